// SPDX-License-Identifier: MIT
// Names and numbers as people read them, and the axes that a point can be plotted along.

const kEngines = {
  lunes: '#2f74d0', rows: '#d97706', pixels: '#7b818c', rays: '#1a9c74', contour: '#b4479b',
};
const kProfiles = ['tiny', 'small', 'medium', 'large', 'host'];
const kCores = {
  'cortex-m0': 'Cortex-M0', 'cortex-m3': 'Cortex-M3', 'cortex-m4f': 'Cortex-M4F', 'cortex-m7': 'Cortex-M7',
  rv32imc: 'RV32IMC', atmega2560: 'ATmega2560', esp8266: 'ESP8266',
};

export const engineColour = (engine) => kEngines[engine] ?? '#5b6069';
export const profileRadius = (profile) => 3 + 1.1 * Math.max(0, kProfiles.indexOf(profile));

export const percent = (value) => `${value < 10 ? value.toPrecision(2) : value.toFixed(0)} %`;

// Three digits and a unit's prefix: 1.23 M.
export function short(value) {
  const prefixes = [[1e9, ' G'], [1e6, ' M'], [1e3, ' k'], [1, '']];
  const [factor, prefix] = prefixes.find(([f]) => value >= f) ?? [1, ''];
  return `${Number((value / factor).toPrecision(3))}${prefix}`;
}

export const seconds = (value) =>
  value >= 1 ? `${Number(value.toPrecision(3))} s` : `${Number((value * 1000).toPrecision(3))} ms`;

export const bytes = (value) => (value < 1024 ? `${value} B` : `${Number((value / 1024).toPrecision(3))} KB`);

// Of lunes, R is the most rows that a shot takes from one point; of rays, the number between two elements.
const samples = (p) =>
  p.engine === 'rays' ? `, ${p.resolution} a pair` : p.resolution > 0 ? `, R ${p.resolution}` : '';
export const engineName = (p) => `${p.engine}${samples(p)}`;
export const settingName = (p) => `${engineName(p)}, ${p.elements} elements`;

// A part of the emitted flux as people say it: 1/6400.
export const part = (value) => (value >= 1 ? String(value) : `1/${short(1 / value)}`);

// What the horizontal axis can show: {id, name, label, of(point), text(value)}.
export function axesOf(data) {
  const host = {
    id: 'seconds', name: 'seconds on this PC', label: 'seconds on the PC that made this page, one core',
    of: (p) => p.seconds, text: seconds,
  };
  const targets = data.targets.map((t) => ({
    id: t.id, name: `${t.unit} on ${kCores[t.id] ?? t.id}`,
    label: `${t.unit} on ${kCores[t.id] ?? t.id}, from a model within ${t.residual.toFixed(1)} % of measurements`,
    of: (p) => p.costs[t.id] ?? null, text: short,
  }));
  return [host, ...targets];
}

// Indices of the points that no other beats in both cost and error, by rising cost.
export function frontierOf(points, cost, error) {
  const order = points.map((_, i) => i)
    .sort((a, b) => cost(points[a]) - cost(points[b]) || error(points[a]) - error(points[b]));
  const frontier = [];
  for (const i of order) {
    if (frontier.length === 0 || error(points[i]) < error(points[frontier.at(-1)])) {
      frontier.push(i);
    }
  }
  return frontier.map((i) => points[i]);
}
