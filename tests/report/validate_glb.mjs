// SPDX-License-Identifier: MIT
// node validate_glb.mjs FILE.glb...: exit 0 only if the Khronos validator has neither errors nor warnings for any.
import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';

const files = process.argv.slice(2);
let faults = files.length === 0 ? 1 : 0;
for (const file of files) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), { uri: file, format: 'glb' });
  const { numErrors, numWarnings, messages } = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings`);
  for (const { code, message, pointer } of messages) {
    console.log(`  ${code}: ${message} (${pointer})`);
  }
  faults += numErrors + numWarnings;
}
process.exitCode = faults === 0 ? 0 : 1;
