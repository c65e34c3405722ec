// Formulas are typeset by MathJax, which is loaded on pages that have any. What takes much time waits for Formulas.typeset.
const Formulas = {
  typeset: Promise.resolve(),

  init() {
    document.addEventListener('DOMContentLoaded', () => {
      const listing = location.pathname.endsWith('_source.html');
      if (listing || !/\\[[(]/.test(document.body.textContent)) return;
      this.typeset = new Promise(done => this.load(done));
      this.typeset.then(() => document.querySelectorAll('script[type="math/tex"]').forEach(this.keepMark));
    });
  },

  load(done) {
    window.MathJax = {
      extensions: ['tex2jax.js', 'TeX/AMSmath.js', 'TeX/AMSsymbols.js', 'TeX/boldsymbol.js'],
      jax: ['input/TeX', 'output/SVG'],
      messageStyle: 'none', showMathMenu: false, SVG: {linebreaks: {automatic: true}},
      AuthorInit: () => MathJax.Hub.Register.StartupHook('End', done),
    };
    const script = document.createElement('script');
    Object.assign(script, {src: 'mathjax/MathJax.js', onerror: done});
    document.head.append(script);
  },

  // A comma after a formula stays on its line.
  keepMark(source) {
    const after = source.nextSibling;
    const mark = after && after.nodeType === Node.TEXT_NODE && /^[.,;:!?)]+/.exec(after.data);
    const formula = source.previousSibling;
    if (!mark || !formula) return;
    const whole = document.createElement('span');
    whole.style.whiteSpace = 'nowrap';
    after.splitText(mark[0].length);
    formula.before(whole);
    whole.append(formula, source, after);
  },
};
Formulas.init();
