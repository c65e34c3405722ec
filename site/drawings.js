// Drawings that can be dragged. A page has
//
//   <figure class="drawing" data-drawing="NAME"><svg viewBox="...">...</svg><figcaption>...</figcaption></figure>
//
// and without scripts that is all. With them drawn.js redraws the picture by its Drawings.NAME:
//
//   controls  [{name, low, high, step, value, text}] sliders, or {name, choices, value, text}, or {name, steps: true, ...}
//             for a slider with buttons to go back and on
//   handles   (values) => [{name, x, y, text}] points that can be dragged, or moved with the arrow keys
//   moved     (values, name, x, y) => values that change when a handle is dragged to x, y
//   draw      (pen, values) the picture
//   say       (values) => a sentence below it, also for those who do not see the picture
class Drawing {
  static init() {
    document.addEventListener('DOMContentLoaded', () => {
      for (const figure of document.querySelectorAll('figure.drawing[data-drawing]')) {
        const what = Drawings[figure.dataset.drawing];
        if (what && (!what.ready || what.ready())) new Drawing(figure, what);
      }
    });
  }

  constructor(figure, what) {
    this.what = what;
    this.values = {};
    const still = figure.querySelector('svg, img');
    this.svg = still.tagName === 'IMG' ? Drawing.element('svg', {viewBox: what.box, role: 'img'}) : still;
    if (this.svg !== still) {
      this.svg.setAttribute('aria-label', still.alt);
      still.replaceWith(this.svg);
    }
    const bar = document.createElement('div');
    bar.className = 'controls';
    for (const control of what.controls) bar.append(...this.control(control));
    this.said = document.createElement('p');
    this.said.className = 'said';
    this.said.setAttribute('aria-live', 'polite');
    this.svg.after(bar, this.said);
    figure.classList.add('dragged');
    this.layer = Drawing.element('g');
    this.top = Drawing.element('g');
    this.svg.replaceChildren(this.layer, this.top);
    this.handles = (what.handles?.(this.values) ?? []).map(handle => this.handle(handle));
    this.show();
  }

  static element(name, attributes = {}) {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  }

  control({name, low, high, step, value, choices, steps, text}) {
    this.values[name] = value;
    const label = document.createElement('label');
    const input = document.createElement(choices ? 'select' : 'input');
    if (choices) input.append(...choices.map(choice => new Option(choice, choice, false, choice === value)));
    else Object.assign(input, {type: 'range', min: low, max: high, step, value});
    input.addEventListener('input', () => {
      this.values[name] = choices ? input.value : Number(input.value);
      this.show();
    });
    label.append(`${text} `, input);
    if (!steps) return [label];
    const button = (word, by) => {
      const made = document.createElement('button');
      Object.assign(made, {type: 'button', textContent: word});
      made.addEventListener('click', () => {
        input.value = this.values[name] + by;
        input.dispatchEvent(new Event('input'));
      });
      return made;
    };
    return [button('Back', -1), label, button('Forward', 1)];
  }

  handle({name, text}) {
    const dot = Drawing.element('circle', {r: 11, class: 'handle', tabindex: 0, role: 'button', 'aria-label': text});
    const move = (x, y) => {
      Object.assign(this.values, this.what.moved(this.values, name, x, y));
      this.show();
    };
    dot.addEventListener('pointerdown', event => {
      event.preventDefault();
      dot.setPointerCapture(event.pointerId);
      dot.focus();
    });
    dot.addEventListener('pointermove', event => {
      if (!dot.hasPointerCapture(event.pointerId)) return;
      const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
      move(point.x, point.y);
    });
    dot.addEventListener('keydown', event => {
      const by = {ArrowLeft: [-4, 0], ArrowRight: [4, 0], ArrowUp: [0, -4], ArrowDown: [0, 4]}[event.key];
      if (!by) return;
      event.preventDefault();
      move(Number(dot.getAttribute('cx')) + by[0], Number(dot.getAttribute('cy')) + by[1]);
    });
    this.top.append(dot);
    return dot;
  }

  show() {
    const pen = new Pen();
    this.what.draw(pen, this.values);
    this.layer.innerHTML = pen.text;
    (this.what.handles?.(this.values) ?? []).forEach(({x, y}, k) => {
      this.handles[k].setAttribute('cx', x);
      this.handles[k].setAttribute('cy', y);
    });
    this.said.textContent = this.what.say(this.values);
  }
}

// Parts of a picture, each with a class that custom.css knows: arc and way are the two colours.
class Pen {
  text = '';

  static round(numbers) {
    return numbers.map(one => Math.round(10 * one) / 10);
  }

  line(x1, y1, x2, y2, kind = '') {
    [x1, y1, x2, y2] = Pen.round([x1, y1, x2, y2]);
    this.text += `<line class="${kind}" x1="${x1}" y1="${y1}" x2="${x2}" y2="${y2}"/>`;
  }

  shape(points, kind = '', closed = true) {
    this.text += `<${closed ? 'polygon' : 'polyline'} class="${kind}" points="${Pen.round(points.flat()).join(' ')}"/>`;
  }

  dot(x, y, kind = 'dot', r = 5) {
    [x, y] = Pen.round([x, y]);
    this.text += `<circle class="${kind}" cx="${x}" cy="${y}" r="${r}"/>`;
  }

  say(x, y, words, kind = '', anchor = 'start') {
    [x, y] = Pen.round([x, y]);
    this.text += `<text class="${kind}" x="${x}" y="${y}" text-anchor="${anchor}">${words}</text>`;
  }
}
