// Figures that run. A page has
//
//   <figure class="live" data-live="scene=pyramid&technique=damped">
//   <img src="figures/NAME.svg" alt="...">
//   <figcaption>What it shows. <span class="try">What to try.</span></figcaption></figure>
//
// and without scripts that is all, but for what to try. Where the site has the live page, it takes the place of
// the picture when that comes into sight, opened by the link in data-live; a span of class "still", about the
// picture alone, goes. Far out of sight the picture is back, and the scene begins anew next time: a browser
// keeps few such drawings alive at once. A figure may have controls for settings of the link,
//
//   data-controls='[{"key": "vs.k_scale", "low": 0, "high": 4, "step": 0.5, "value": 1, "text": "strength"}]'
//
// or with "choices" in place of the numbers; the scene begins anew with what was chosen.
class Live {
  static here = false; // where cmake/site puts the live page, it adds a line to site.js that says otherwise

  static init() {
    document.addEventListener('DOMContentLoaded', () => {
      const figures = [...document.querySelectorAll('figure.live')].map(figure => new Live(figure));
      if (!Live.here || figures.length === 0) return;
      const of = ({target}) => figures.find(one => one.stage === target);
      const near = new IntersectionObserver(entries => entries.filter(one => !one.isIntersecting)
        .forEach(one => of(one).stop()), {rootMargin: '100%', scrollMargin: '100%'});
      const seen = new IntersectionObserver(entries => entries.filter(one => one.isIntersecting)
        .forEach(one => of(one).start()), {threshold: 0.2});
      figures.forEach(({stage}) => [near, seen].forEach(observer => observer.observe(stage)));
    });
  }

  constructor(figure) {
    this.picture = figure.querySelector('img');
    this.link = `live/index.html#${figure.dataset.live}`;
    const caption = figure.querySelector('figcaption');
    if (!Live.here) {
      const scene = new URLSearchParams(figure.dataset.live).get('scene');
      caption.insertAdjacentHTML('beforeend', ` <small>In motion: <code>make view SCENE=${scene}</code>. It runs here ` +
        'once <code>make live</code> has installed what that needs and <code>make site</code> has been run again.</small>');
      return;
    }
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
