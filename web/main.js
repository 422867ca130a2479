// SPDX-License-Identifier: MIT
// The page of `fixrad sweep`: what can be chosen, and what follows from it.
import { drawChart } from './chart.js';
import { axesOf, bytes, engineColour, frontierOf, part, percent, profileRadius, settingName } from './figures.js';
import { Table } from './table.js';
import { Views } from './views.js';

const $ = (id) => document.getElementById(id);
const data = JSON.parse($('data').textContent);
const axes = axesOf(data);
const kMemories = [6144, 13312, 61440, 491520];
const state = { axis: axes[0], error: 'error', ram: Infinity, selected: middleOf(data.showcase.solutions) };

function element(name, text, properties = {}) {
  return Object.assign(document.createElement(name), { textContent: text, ...properties });
}

function middleOf(solutions) {
  return data.points[solutions[Math.floor(solutions.length / 2)].point];
}

function visiblePoints() {
  return data.points.filter((p) => p.ram <= state.ram && state.axis.of(p) !== null);
}

// An option is not torn from its dashes; a long path may break anywhere.
function commandText(text) {
  const code = document.createElement('code');
  code.append(...text.split(/(?= --)/).map((part) => {
    const [, space, option, rest] = /^( ?)(--\S+)?([^]*)$/.exec(part);
    const whole = element('span', option ?? '', { className: 'option' });
    const all = document.createDocumentFragment();
    all.append(space, whole, rest);
    return all;
  }));
  return code;
}

function drawSetting(point) {
  const host = $('setting');
  if (!point) {
    host.replaceChildren(element('p', 'Choose a point to see its command.', { className: 'hint' }));
    return;
  }
  const list = document.createElement('dl');
  const rows = [
    ['profile', point.profile], ['patches', point.patches], ['shots', point.shots], ['eye points', point.eyes],
    ['flux a row', part(point.flux_per_row)], ['flux an eye point', part(point.flux_per_eye)],
    ['solver RAM', bytes(point.ram)], ['mean error', percent(point.error)], ['worst face', percent(point.worst)],
    ...axes.filter((a) => a.of(point) !== null).map((a) => [a.name, a.text(a.of(point))]),
  ];
  for (const [name, value] of rows) {
    list.append(element('dt', name), element('dd', value));
  }
  const command = commandText(point.command);
  const copy = element('button', 'copy command', { type: 'button' });
  copy.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(point.command);
      copy.textContent = 'copied';
    } catch {
      getSelection().selectAllChildren(command);
      copy.textContent = 'selected: copy it';
    }
  });
  host.replaceChildren(element('h3', settingName(point)), list, command, copy);
}

function drawKeys(points) {
  const key = (mark, text) => {
    const item = document.createElement('span');
    item.append(mark, text);
    return item;
  };
  const disc = (radius, colour) => {
    const mark = element('b', '', { className: 'dot' });
    Object.assign(mark.style, { width: `${2 * radius}px`, height: `${2 * radius}px`, background: colour });
    return mark;
  };
  const values = (name) => [...new Set(points.map((p) => p[name]))];
  $('keys').replaceChildren(
    ...values('engine').map((engine) => key(disc(5, engineColour(engine)), engine)),
    ...values('profile').map((profile) => key(disc(profileRadius(profile), 'currentColor'), profile)),
    key(element('b', '', { className: 'stroke' }), 'frontier: nothing is both faster and more accurate'));
}

function draw() {
  const points = visiblePoints();
  const frontier = frontierOf(points, state.axis.of, (p) => p[state.error]);
  if (!points.includes(state.selected)) {
    state.selected = frontier.at(-1) ?? null;
    views.showPoint(state.selected);
  }
  drawChart($('chart'), { ...state, points, frontier }, select);
  drawKeys(points);
  drawSetting(state.selected);
  table.draw(points, state.selected);
}

function select(point) {
  state.selected = point;
  views.showPoint(point);
  draw();
}

function drawText() {
  $('scene').textContent = data.scene;
  const engines = [...new Set(data.points.map((p) => p.engine))];
  $('summary').textContent =
    `${data.points.length} settings of ${engines.join(', ')}, each solved to ${data.unshot} % unshot light and measured ` +
    `against path-traced truth, whose own standard error is ${percent(data.truth_error)}.`;
  $('views-note').textContent = `${data.showcase.solutions.length} of the settings have them.`;
  const withoutCost = engines.filter((e) => !data.targets.some((t) => t.engines.includes(e)));
  const notes = [
    'A circle is one setting: engine by colour, memory profile by size. Host seconds are of one core of the PC that made ' +
      'this page; everything else is the same on every machine.',
    'Mean error: difference of the mean radiosity of faces to the truth, weighted by area, faces that emit left out. ' +
      'Worst face: of the faces with at least a tenth of the scene’s mean radiosity.',
    'Instructions and cycles come from steps counted on the host, weighted by what each step costs on the core. The ' +
      'weights are fitted to exact counts of whole solutions in emulators; the largest deviation from these: ' +
      `${data.targets.map((t) => `${t.id} ${t.residual.toFixed(1)} % of ${t.measurements}`).join(', ')}. ` +
      'Whether a setting fits a chip’s memory is another question: see its RAM.' +
      (withoutCost.length > 0 ? ` Not measured on any core, so with seconds only: ${withoutCost.join(', ')}.` : ''),
    'Flux a row: a shot is sampled with one row for each such part of the emitted flux, so what is left of it steers ' +
      'accuracy against time; lunes take at most R of them from one point, the other engines a fixed number from each.',
  ];
  $('notes').replaceChildren(...notes.map((text) => element('p', text)));
}

function start() {
  $('axis').replaceChildren(...axes.map((a) => new Option(a.name, a.id)));
  $('ram').replaceChildren(new Option('any', 'Infinity'),
    ...kMemories.map((ram) => new Option(`at most ${bytes(ram)}`, ram)));
  $('axis').addEventListener('change', (event) => {
    state.axis = axes.find((a) => a.id === event.target.value);
    draw();
  });
  $('error').addEventListener('change', (event) => {
    state.error = event.target.value;
    draw();
  });
  $('ram').addEventListener('change', (event) => {
    state.ram = Number(event.target.value);
    draw();
  });
  drawText();
  views.showPoint(state.selected);
  let width = 0;
  new ResizeObserver(() => {
    if ($('chart').clientWidth !== width) {
      width = $('chart').clientWidth;
      draw();
    }
  }).observe($('chart'));
}

const views = new Views(data, select);
const table = new Table($('table'), axes, select);
start();
