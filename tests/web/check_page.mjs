// SPDX-License-Identifier: MIT
// node check_page.mjs PAGE.html TABLE.csv CHROMIUM [SHOTS]: exit 0 only if the page draws the settings of the table
// and all else that it promises, offline, without a complaint of the browser. SHOTS: a folder for screenshots.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { PNG } from 'pngjs';

const [page_file, table_file, executablePath, shots] = process.argv.slice(2);
const kSizes = { desktop: { width: 1280, height: 900 }, phone: { width: 390, height: 844 } };
const kDriver = /GPU stall due to ReadPixels/; // the software renderer's remark on screenshots

const rows = readFileSync(table_file, 'utf8').trimEnd().split('\n');
const header = rows.shift().split(',');
const field = (row, name) => row.split(',')[header.indexOf(name)];
const circles = (page) => page.locator('#chart g.settings circle').count();
const complaints = [];

async function open(browser, size, colorScheme) {
  const context = await browser.newContext({ viewport: size, colorScheme });
  const page = await context.newPage();
  page.on('console', (message) =>
    ['error', 'warning'].includes(message.type()) && !kDriver.test(message.text()) && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) =>
    !/^(file|data|blob):/.test(request.url()) && complaints.push(`request to ${request.url()}`));
  await page.goto(pathToFileURL(page_file).href);
  await page.locator('#chart svg').waitFor();
  return page;
}

async function colours(locator) {
  const { data } = PNG.sync.read(await locator.screenshot());
  const seen = new Set();
  for (let i = 0; i < data.length; i += 4) {
    seen.add(data.readUInt32BE(i));
  }
  return seen.size;
}

async function checkMarks(page) {
  assert.equal(await circles(page), rows.length, 'a circle for each row of the table');
  for (const option of await page.locator('#axis option').all()) {
    const id = await option.getAttribute('value');
    await page.selectOption('#axis', id);
    const column = id === 'seconds' ? 'host_seconds' : header.find((name) => name.startsWith(id.replaceAll('-', '_')));
    const filled = rows.filter((row) => field(row, column) !== '').length;
    assert.equal(await circles(page), filled, `a circle for each row with a figure in ${column}`);
  }
  await page.selectOption('#axis', 'seconds');
  await page.selectOption('#ram', '6144');
  const small = rows.filter((row) => Number(field(row, 'ram_bytes')) <= 6144).length;
  assert.ok(small > 0 && small < rows.length, 'the sweep has settings on both sides of the limit');
  assert.equal(await circles(page), small, 'only settings within the memory');
  assert.equal(await page.locator('#table tbody tr').count(), small, 'and as many rows');
  await page.selectOption('#ram', 'Infinity');
}

// The circles of all settings, placed by scales that are read off two of the table's own figures.
async function checkPlaces(page) {
  const placed = await page.locator('#chart g.settings circle').evaluateAll((marks) =>
    marks.map((m) => [Number(m.getAttribute('cx')), Number(m.getAttribute('cy'))]));
  const figures = rows.map((row) => [
    Math.log(field(row, 'host_seconds')), Math.log(field(row, 'mean_error_percent'))]);
  for (const axis of [0, 1]) {
    const pairs = figures.map((f, i) => f[axis]).sort((a, b) => a - b);
    const places = placed.map((p) => p[axis]).sort((a, b) => (axis === 0 ? a - b : b - a));
    const slope = (places.at(-1) - places[0]) / (pairs.at(-1) - pairs[0]);
    pairs.forEach((value, i) =>
      assert.ok(Math.abs(places[0] + slope * (value - pairs[0]) - places[i]) < 1, 'circles lie where the table says'));
  }
}

async function checkSelection(page) {
  const wanted = page.locator('#table tbody tr').first();
  await wanted.click();
  const command = await page.locator('#setting code').textContent();
  assert.ok(rows.some((row) => row.endsWith(command) || row.endsWith(`"${command}"`)), `the table has the command ${command}`);
  assert.equal(await page.locator('#chart g.selected circle').count(), 1);
  const mark = page.locator('#chart g.settings circle').first();
  await mark.scrollIntoViewIfNeeded();
  const box = await mark.boundingBox();
  await page.mouse.move(box.x + box.width / 2 + 1, box.y + box.height / 2 + 1);
  await page.locator('#chart g[aria-label="tip"] text').waitFor();
  const tip = await page.locator('#chart g[aria-label="tip"]').textContent();
  assert.match(tip.replace(/\s+/g, ' '), /fixrad ?bake/, 'hovering shows the command');
}

async function checkPictures(page) {
  for (const id of ['baked', 'reference', 'map']) {
    const width = await page.locator(`#${id}`).evaluate(async (image) => (await image.decode(), image.naturalWidth));
    assert.ok(width > 100, `${id} is a picture`);
    assert.ok((await colours(page.locator(`#${id}`))) > 100, `${id} is not blank`);
  }
  const before = await page.locator('#map').getAttribute('src');
  await page.locator('[data-map="face_errors"]').click();
  assert.notEqual(await page.locator('#map').getAttribute('src'), before, 'by face is another map');
  assert.equal(await page.locator('#scale span').count(), 7, 'the scale has five numbers and two ends');
  await page.locator('[data-map="point_errors"]').click();
}

async function checkModel(page) {
  const canvas = page.locator('#model canvas');
  await canvas.scrollIntoViewIfNeeded();
  await page.waitForTimeout(300);
  const before = await canvas.screenshot();
  assert.ok((await colours(canvas)) > 100, 'the model is not blank');
  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height / 2 + 20, { steps: 4 });
  await page.mouse.up();
  assert.ok(!before.equals(await canvas.screenshot()), 'the model turns');
  await page.locator('#home').click();
}

async function checkFits(page) {
  const [content, window] = await page.evaluate(() =>
    [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(content <= window, `nothing sticks out of the page: ${content} of ${window} pixels`);
}

const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader'] });
try {
  const page = await open(browser, kSizes.desktop, 'light');
  await checkMarks(page);
  await checkPlaces(page);
  await checkSelection(page);
  await checkPictures(page);
  await checkModel(page);
  for (const [name, size] of Object.entries(kSizes)) {
    for (const scheme of ['light', 'dark']) {
      const view = await open(browser, size, scheme);
      await checkFits(view);
      if (shots) {
        await view.waitForTimeout(500);
        await view.screenshot({ path: `${shots}/${name}_${scheme}.png`, fullPage: true });
        await view.screenshot({ path: `${shots}/${name}_${scheme}_top.png` });
      }
      await view.context().close();
    }
  }
  assert.deepEqual(complaints, [], 'the browser has nothing to complain about');
} finally {
  await browser.close();
}
console.log(`${rows.length} settings drawn, no complaint`);
