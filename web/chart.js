// SPDX-License-Identifier: MIT
// The plane of cost and error: a circle a setting, the frontier as a line.
import { dot, line, plot, pointer, tip } from '@observablehq/plot';
import { engineColour, part, percent, profileRadius, settingName } from './figures.js';

const kPhone = 560; // pixels of width
const kTipColumns = 52; // letters

// Marks of a logarithmic scale that keep their label: 1, 2 and 5 of a decade, 1 alone where it is long.
function labelled(domain) {
  const decades = Math.log10(domain[1] / domain[0]);
  const digits = decades > 3 ? [1] : [1, 2, 5];
  return (value) => digits.includes(Math.round(value / 10 ** Math.floor(Math.log10(value) + 1e-9)));
}

// A command in lines that do not tear an option from its dashes.
function commandLines(command) {
  const lines = [''];
  for (const part of command.split(/ (?=--)/)) {
    const longer = lines.at(-1) === '' ? part : `${lines.at(-1)} ${part}`;
    if (longer.length <= kTipColumns || lines.at(-1) === '') {
      lines[lines.length - 1] = longer;
    } else {
      lines.push(part);
    }
  }
  return lines;
}

function describe(p, axis) {
  return [
    settingName(p), `profile ${p.profile}, ${part(p.flux_per_row)} of the flux a row`,
    `error ${percent(p.error)} in the mean, ${percent(p.worst)} at the worst face`,
    `${axis.name}: ${axis.text(axis.of(p))}`, '', ...commandLines(p.command),
  ].join('\n');
}

export function drawChart(host, state, select) {
  const { points, frontier, axis, error, selected } = state;
  const width = host.clientWidth;
  const isPhone = width < kPhone;
  const best = new Set(frontier);
  const x = axis.of;
  const y = (p) => p[error];
  const range = (values) => [Math.min(...values) / 1.25, Math.max(...values) * 1.25];
  const xDomain = points.length > 0 ? range(points.map(x)) : [0.01, 1];
  const yDomain = points.length > 0 ? range(points.map(y)) : [0.1, 10];
  const hasXLabel = labelled(xDomain);
  const hasYLabel = labelled(yDomain);
  const colour = (p) => engineColour(p.engine);
  const chart = plot({
    width, height: isPhone ? 340 : 480, marginLeft: 56, marginBottom: 46, marginRight: 14,
    ariaLabel: `${points.length} settings by cost and error`,
    style: { fontSize: '13px', background: 'transparent' },
    x: {
      type: 'log', domain: xDomain, grid: true, ticks: isPhone ? 5 : undefined, labelAnchor: 'center', labelArrow: 'none',
      label: isPhone ? axis.name : axis.label, tickFormat: (v) => (hasXLabel(v) ? axis.text(v) : ''),
    },
    y: {
      type: 'log', domain: yDomain, grid: true, labelArrow: 'none',
      label: error === 'error' ? 'mean error of faces' : 'error of the worst face',
      tickFormat: (v) => (hasYLabel(v) ? `${Number(v.toPrecision(2))} %` : ''),
    },
    marks: [
      line(frontier, { x, y, stroke: 'currentColor', strokeWidth: 1.5, strokeOpacity: 0.7, curve: 'step-after' }),
      dot(points, {
        x, y, r: (p) => profileRadius(p.profile), fill: colour, stroke: (p) => (best.has(p) ? 'currentColor' : colour(p)),
        fillOpacity: (p) => (best.has(p) ? 0.95 : 0.4), strokeOpacity: (p) => (best.has(p) ? 1 : 0.55),
        strokeWidth: 1.2, className: 'settings',
      }),
      dot(selected ? [selected] : [], { x, y, r: 11, stroke: 'currentColor', strokeWidth: 2, className: 'selected' }),
      tip(points, pointer({
        x, y, maxRadius: 30, title: (p) => describe(p, axis), lineWidth: isPhone ? 22 : 34, fontSize: 12, lineHeight: 1.3,
        fill: 'var(--card)', stroke: 'var(--line)',
      })),
    ],
    r: { type: 'identity' },
    color: { type: 'identity' },
  });
  chart.addEventListener('click', () => chart.value && select(chart.value));
  host.replaceChildren(chart);
}
