// Figures that run. A page has
//
//   <figure class="live" data-live="scene=pyramid&technique=damped">
//   <img src="figures/NAME.svg" alt="...">
//   <figcaption>What it shows. <span class="try">What to try.</span></figcaption></figure>
//
// and without scripts, or without WebGL to draw with, that is all, but for what to try. With them the live
// page takes the place of the picture when that comes into sight, opened by the link in data-live; a span of class "still", about the
// picture alone, goes. Far out of sight the picture is back, and the scene begins anew next time: a browser
// keeps few such drawings alive at once. A figure may have controls for settings of the link,
//
//   data-controls='[{"key": "vs.k_scale", "low": 0, "high": 4, "step": 0.5, "value": 1, "text": "strength"}]'
//
// or with "choices" in place of the numbers; the scene begins anew with what was chosen.
class Live {
  static init() {
    document.addEventListener('DOMContentLoaded', () => {
      const found = [...document.querySelectorAll('figure.live')];
      // check.py asks for scenes that run without being drawn, which takes less time.
      const drawn = location.search === '?undrawn' || document.createElement('canvas').getContext('webgl2');
      if (found.length === 0 || !drawn) return;
      const figures = found.map(figure => new Live(figure));
      const of = ({target}) => figures.find(one => one.stage === target);
      const near = new IntersectionObserver(entries => entries.filter(one => !one.isIntersecting)
        .forEach(one => of(one).stop()), {rootMargin: '100%', scrollMargin: '100%'});
      const seen = new IntersectionObserver(entries => entries.filter(one => one.isIntersecting)
        .forEach(one => of(one).start()), {threshold: 0.2});
      const observed = ({stage}) => [near, seen].forEach(observer => observer.observe(stage));
      Formulas.typeset.then(() => figures.forEach(observed));  // before scenes take the time
    });
  }

  constructor(figure) {
    this.picture = figure.querySelector('img');
    this.link = `live/index.html#${figure.dataset.live}`;
    const caption = figure.querySelector('figcaption');
    this.stage = document.createElement('div');
    this.stage.className = 'stage';
    this.picture.replaceWith(this.stage);
    this.stage.append(this.picture);
    figure.classList.add('runs');
    const alone = document.createElement('a');
    Object.assign(alone, {href: this.link, target: '_blank', rel: 'noopener', textContent: 'Open on its own'});
    caption.append(' ', alone);
    this.alone = alone;
    const bar = document.createElement('div');
    bar.className = 'controls';
    for (const control of JSON.parse(figure.dataset.controls ?? '[]')) bar.append(this.control(control));
    if (bar.firstChild) this.stage.after(bar);
  }

  control({key, low, high, step, value, choices, text}) {
    const label = document.createElement('label');
    const input = document.createElement(choices ? 'select' : 'input');
    const shown = document.createElement('output');
    if (choices) input.append(...choices.map(choice => new Option(choice, choice, false, choice === value)));
    else Object.assign(input, {type: 'range', min: low, max: high, step, value});
    const say = () => { shown.textContent = choices ? '' : input.value; };
    input.addEventListener('input', say);
    input.addEventListener('change', () => {
      const [page, words] = this.link.split('#');
      const kept = words.split('&').filter(word => !word.startsWith(`${key}=`));
      this.link = this.alone.href = `${page}#${[...kept, `${key}=${input.value}`].join('&')}`;
      if (this.stage.firstChild === this.picture) return;
      this.stop();
      this.start();
    });
    say();
    label.append(`${text} `, input, shown);
    return label;
  }

  start() {
    if (this.stage.firstChild !== this.picture) return;
    const frame = document.createElement('iframe');
    Object.assign(frame, {src: `${this.link}&embed=1`, title: `Live: ${this.picture.alt}`});
    this.stage.replaceChildren(frame);
  }

  stop() {
    if (this.stage.firstChild !== this.picture) this.stage.replaceChildren(this.picture);
  }
}
