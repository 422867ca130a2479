// SPDX-License-Identifier: MIT
// node build.mjs OUTPUT.cpp [OUTPUT.html]: bundles the page into one HTML text and writes it as a string in C++. The
// page may run its own script only, which its hash names, and may ask nothing of any network.
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const kLiteral = 8000; // bytes of a string literal; compilers promise 65,536

const bundle = async (entry) => {
  const result = await build({
    entryPoints: [entry], bundle: true, minify: true, write: false, charset: 'ascii', target: 'es2020',
    format: entry.endsWith('.js') ? 'iife' : undefined, legalComments: 'none',
  });
  return result.outputFiles[0].text.trimEnd();
};

const literal = (bytes) => {
  let text = '"';
  for (const byte of bytes) {
    const plain = byte >= 32 && byte < 127 && byte !== 34 && byte !== 92 && byte !== 63;
    text += plain ? String.fromCharCode(byte) : `\\${byte.toString(8).padStart(3, '0')}`;
  }
  return `${text}"`;
};

const script = (await bundle('main.js')).replaceAll('</script', '<\\/script');
const style = await bundle('style.css');
const hash = `'sha256-${createHash('sha256').update(script).digest('base64')}'`;
const page = readFileSync('page.html', 'utf8')
  .replace('@SCRIPT_HASH@', () => hash)
  .replace('@STYLE@', () => style)
  .replace('@SCRIPT@', () => script);

const bytes = Buffer.from(page, 'utf8');
const parts = [];
for (let at = 0; at < bytes.length; at += kLiteral) {
  parts.push(`    {${literal(bytes.subarray(at, at + kLiteral))}, ${Math.min(kLiteral, bytes.length - at)}},`);
}
writeFileSync(process.argv[2], `// Made by web/build.mjs; do not edit.
#include "host_sim/report/data_page.h"

namespace fixrad::host {
namespace {

constexpr std::string_view kParts[] = {
${parts.join('\n')}
};

}  // namespace

std::string_view page_template() {
  static const std::string page = [] {
    std::string text;
    for (const std::string_view part : kParts) {
      text += part;
    }
    return text;
  }();
  return page;
}

}  // namespace fixrad::host
`);
if (process.argv[3]) {
  writeFileSync(process.argv[3], page);
}
