// SPDX-License-Identifier: MIT
// Pictures of one setting beside the reference, the map of its errors, and its model.
import { engineName, percent, settingName } from './figures.js';
import { ModelView } from './model.js';

const $ = (id) => document.getElementById(id);

function drawScale(host, colours, limit) {
  const ramp = document.createElement('i');
  ramp.style.background = `linear-gradient(to right, ${colours.map((c) => `rgb(${c})`).join(', ')})`;
  const numbers = document.createElement('div');
  for (const part of [-1, -0.5, 0, 0.5, 1]) {
    const number = document.createElement('span');
    const value = Number((part * limit).toPrecision(3));
    number.textContent = `${value > 0 ? '+' : value < 0 ? '\u2212' : ''}${Math.abs(value)} %`;
    numbers.append(number);
  }
  const ends = document.createElement('div');
  ends.className = 'ends';
  ends.append(Object.assign(document.createElement('span'), { textContent: 'too dark' }),
    Object.assign(document.createElement('span'), { textContent: 'too bright' }));
  host.replaceChildren(ramp, numbers, ends);
}

function press(buttons, isPressed) {
  for (const button of buttons) {
    button.setAttribute('aria-pressed', isPressed(button));
  }
}

export class Views {
  constructor(data, select) {
    this.data = data;
    this.shown = data.showcase.solutions.at(-1);
    this.map = 'point_errors';
    this.model = 'baked';
    this.maps = [...document.querySelectorAll('[data-map]')];
    this.models = [...document.querySelectorAll('[data-model]')];
    this.maps.forEach((b) => b.addEventListener('click', () => this.set({ map: b.dataset.map })));
    this.models.forEach((b) => b.addEventListener('click', () => this.set({ model: b.dataset.model })));
    this.chips = data.showcase.solutions.map((solution) => {
      const chip = document.createElement('button');
      const point = data.points[solution.point];
      chip.type = 'button';
      chip.textContent = `${point.profile} · ${engineName(point).replace(',', '')} · ${percent(point.error)}`;
      chip.addEventListener('click', () => select(point));
      return chip;
    });
    $('chips').replaceChildren(...this.chips);
    const { reference } = data.showcase;
    $('reference').src = reference.picture;
    $('reference').alt = 'The reference solution';
    $('reference-text').textContent =
      `Reference: ${reference.elements} elements, ${percent(reference.error)} from the path-traced truth`;
    this.startModel();
    this.draw();
  }

  startModel() {
    try {
      this.view = new ModelView($('model'), this.data.showcase.camera);
      $('home').addEventListener('click', () => this.view.home());
    } catch {
      const text = document.createElement('p');
      text.textContent = 'This browser offers no WebGL, which the model needs.';
      $('model').replaceChildren(text);
    }
  }

  // Shows the pictures of a point of the chart, if it has any.
  showPoint(point) {
    const solution = this.data.showcase.solutions.find((s) => this.data.points[s.point] === point);
    if (solution) {
      this.set({ shown: solution });
    }
  }

  set(change) {
    Object.assign(this, change);
    this.draw();
  }

  draw() {
    const { showcase, points } = this.data;
    const point = points[this.shown.point];
    press(this.chips, (chip) => this.chips.indexOf(chip) === showcase.solutions.indexOf(this.shown));
    press(this.maps, (b) => b.dataset.map === this.map);
    press(this.models, (b) => b.dataset.model === this.model);
    $('baked').src = this.shown.picture;
    $('baked').alt = `Baked with ${settingName(point)}`;
    $('baked-text').textContent =
      `Baked: ${settingName(point)}, ${percent(point.error)} mean error, ${percent(point.worst)} worst face`;
    const isByPoint = this.map === 'point_errors';
    $('map').src = this.shown[this.map];
    $('map').alt = `Errors ${isByPoint ? 'by point' : 'by face'} in false colours`;
    $('map-text').textContent = isByPoint
      ? 'Radiosity at each point against the reference; where that is below a tenth of the scene’s mean, relative to this tenth.'
      : 'Mean radiosity of each face against path-traced truth; of dark faces relative to a tenth of the scene’s mean.';
    drawScale($('scale'), showcase.colours, isByPoint ? showcase.point_limit : showcase.face_limit);
    this.view?.show(this.model === 'baked' ? this.shown.model : showcase.reference.model);
  }
}
