// The drawings that can be dragged; see drawings.js.
const Drawings = (() => {
const range = (count, at) => Array.from({length: count}, (_, k) => at(k));
const turned = ([x, y], angle) => [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle)];
// Corners of a box: centre, half edges, angle.
const corners = ([cx, cy], [a, b], angle) => [[-a, -b], [a, -b], [a, b], [-a, b]].map(corner => {
  const [x, y] = turned(corner, angle);
  return [cx + x, cy + y];
});
const minus = number => number.toFixed(2).replace('-', '−');

return {
  // Two boxes that turn about a pivot: centres along tangents, or along arcs.
  tangent: {
    controls: [
      {name: 'turn', low: 0, high: 60, step: 1, value: 29, text: 'turn in a step'},
      {name: 'way', choices: ['along the tangent', 'along the arc'], value: 'along the tangent', text: 'centres go'},
    ],
    draw(pen, {turn, way}) {
      const angle = turn * Math.PI / 180, arc = way === 'along the arc';
      const [px, py] = [70, 330];
      for (const radius of [135, 225]) {
        const [x, y] = turned([0, -radius], angle);
        const end = arc ? [px + x, py + y] : [px + radius * angle, py - radius];
        pen.shape(corners([px, py - radius], [45, 45], 0), 'before');
        pen.shape(corners(end, [45, 45], angle), arc ? 'arc' : 'tangent');
        const path = range(20, k => turned([0, -radius], angle * k / 19)).map(([dx, dy]) => [px + dx, py + dy]);
        pen.shape(path, 'path', false);
        if (!arc) pen.line(px, py - radius, end[0], end[1], 'way');
      }
      pen.dot(px, py);
      pen.say(60, 322, 'p', '', 'end');
      pen.say(360, 330, 'dashed: before the step');
    },
    say({turn, way}) {
      const angle = turn * Math.PI / 180;
      if (way === 'along the arc') return 'The boxes stay together at every step.';
      // Along the turned axis: the difference of the centres is the spacing times (angle, 1).
      const gap = Math.cos(angle) + angle * Math.sin(angle) - 1;
      return `Turn ${turn}°: the joint opens by ${(100 * gap).toFixed(1)} % of an edge; half the square of the turn is ` +
        `${(50 * angle * angle).toFixed(1)} %.`;
    },
  },

  // Force and acceleration of one contact.
  one_contact: {
    controls: [
      {name: 'b', low: -1, high: 1, step: 0.05, value: -0.4, text: 'b, without a force'},
      {name: 'slope', low: 0.1, high: 1.5, step: 0.05, value: 0.4, text: 'A'},
    ],
    draw(pen, {b, slope}) {
      const x = f => 70 + 100 * f, y = a => 150 - 100 * a;
      pen.line(48, 150, 420, 150);
      pen.line(70, 235, 70, 30);
      pen.shape([[70, 34], [70, 150], [410, 150]], 'arc thick', false);
      pen.line(x(-0.15), y(b - 0.15 * slope), x(3.2), y(b + 3.2 * slope), 'way');
      pen.dot(x(Math.max(0, -b / slope)), y(Math.max(0, b)));
      pen.say(425, 168, 'force f', '', 'end');
      pen.say(84, 42, 'acceleration a');
    },
    say({b, slope}) {
      return b < 0 ? `It pushes: f = −b / A = ${minus(-b / slope)}, and a = 0.`
        : `It separates, or just touches: f = 0, and a = b = ${minus(b)}.`;
    },
  },

  // Coulomb's cone and the ellipse of a patch. The handle is the impulse that would stop the patch.
  cone: {
    controls: [{name: 'mu', low: 0.1, high: 1.2, step: 0.05, value: 0.5, text: 'μ'}],
    handles: ({point}) => {
      const [x, y] = point ?? [200, 110];
      return [{name: 'point', x, y, text: 'impulse that would stop the patch: drag it, or use the arrow keys'}];
    },
    moved: (values, name, x, y) => ({point: [Math.min(290, Math.max(10, x)), Math.min(245, Math.max(20, y))]}),
    answer({mu, point}) {
      const [x, y] = point ?? [200, 110];
      const [t, n] = [x - 150, 200 - y];
      if (n >= 0 && Math.abs(t) <= mu * n) return {t, n, how: 'sticks'};
      if (n <= 0) return {t: 0, n: 0, how: 'separates'};
      return {t: Math.sign(t) * mu * n, n, how: 'slides'};
    },
    draw(pen, values) {
      const {t, n, how} = this.answer(values), {mu, point} = values;
      const [x, y] = point ?? [200, 110];
      const up = Math.min(155, 140 / mu);
      pen.shape([[150, 200], [150 - mu * up, 200 - up], [150 + mu * up, 200 - up]], 'arc');
      pen.line(10, 200, 290, 200);
      pen.line(150, 245, 150, 20, 'faint');
      pen.line(150, 200, x, y, 'before');
      pen.line(150, 200, 150 + t, 200 - n, how === 'sticks' ? 'arc thick' : 'way thick');
      pen.say(160, 32, 'pressure N');
      pen.say(288, 218, 'friction F', '', 'end');
      // The same friction across, and a twist upwards, within the limit of this pressure.
      const limit = mu * Math.max(0, n), twist = 0.6 * limit;
      const ring = range(61, k => [450 + limit * Math.cos(k * Math.PI / 30), 130 - twist * Math.sin(k * Math.PI / 30)]);
      pen.line(340, 130, 580, 130);
      pen.line(450, 235, 450, 25);
      pen.shape(ring, 'arc');
      pen.line(450, 130, 450 + t, 130, how === 'sticks' ? 'arc thick' : 'way thick');
      pen.say(460, 36, 'twist T');
      pen.say(582, 122, 'F', '', 'end');
    },
    say(values) {
      const {how} = this.answer(values);
      return {sticks: 'Within the cone: the patch sticks, and this is its impulse.',
        slides: 'Outside: the patch slides, and friction is at its limit μN.',
        separates: 'It would have to pull: no impulse.'}[how] + ' Right: what the same pressure can bear of friction and twist.';
    },
  },

  // Two rectangles and the four directions that can separate them.
  axes: {
    controls: [{name: 'angle', low: -90, high: 90, step: 1, value: 25, text: 'turn'}],
    handles: ({centre}) => {
      const [x, y] = centre ?? [245, 120];
      return [{name: 'centre', x, y, text: 'second box: drag it, or use the arrow keys'}];
    },
    moved: (values, name, x, y) => ({centre: [Math.min(330, Math.max(20, x)), Math.min(240, Math.max(20, y))]}),
    gaps({angle, centre}) {
      const radians = angle * Math.PI / 180;
      const boxes = [corners([120, 140], [60, 40], 0), corners(centre ?? [245, 120], [50, 30], radians)];
      const normals = [[1, 0], [0, 1], turned([1, 0], radians), turned([0, 1], radians)];
      return {boxes, found: normals.map(([nx, ny]) => {
        const reach = boxes.map(box => box.map(([x, y]) => x * nx + y * ny)).map(all => [Math.min(...all), Math.max(...all)]);
        return {reach, gap: Math.max(reach[1][0] - reach[0][1], reach[0][0] - reach[1][1])};
      })};
    },
    draw(pen, values) {
      const {boxes, found} = this.gaps(values);
      const best = Math.max(...found.map(({gap}) => gap));
      pen.shape(boxes[0], 'arc');
      pen.shape(boxes[1], 'way');
      ['1, across', '1, up', '2, across', '2, up'].forEach((name, k) => {
        const {reach, gap} = found[k], y = 45 + 55 * k, low = Math.min(reach[0][0], reach[1][0]);
        const x = at => 400 + 0.55 * (at - low);
        pen.say(400, y - 12, `box ${name}: ${gap > 0 ? 'gap' : 'overlap'} ${Math.abs(gap).toFixed(0)}`,
          gap === best ? 'good' : '');
        pen.line(x(reach[0][0]), y, x(reach[0][1]), y, 'arc thick');
        pen.line(x(reach[1][0]), y + 7, x(reach[1][1]), y + 7, 'way thick');
      });
    },
    say(values) {
      const best = Math.max(...this.gaps(values).found.map(({gap}) => gap));
      return best > 0 ? `Apart: one direction has a gap, and one is enough. The largest is d = ${best.toFixed(0)}.`
        : `They overlap: no direction has a gap. The smallest overlap is the depth, d = ${best.toFixed(0).replace('-', '−')}.`;
    },
  },

  // The interval of a bisection.
  bisection: {
    controls: [{name: 'step', steps: true, low: 0, high: 8, step: 1, value: 3, text: 'halvings'}],
    gap: t => 0.62 - 1.35 * t + 0.12 * t * t,
    brackets(count) {
      const all = [[0, 1]];
      for (let k = 0; k < count; ++k) {
        const [low, high] = all[k], middle = (low + high) / 2;
        all.push(this.gap(middle) > 0 ? [middle, high] : [low, middle]);
      }
      return all;
    },
    draw(pen, {step}) {
      const x = t => 60 + 480 * t;
      pen.line(50, 110, 560, 110);
      pen.shape(range(25, k => [x(k / 24), 110 - 110 * this.gap(k / 24)]), 'arc', false);
      this.brackets(step).forEach(([low, high], k) => {
        const y = 205 + 9 * k, end = k === step ? 'way thick' : 'way';
        pen.line(x(low), y, x(high), y, end);
        for (const t of [low, high]) pen.line(x(t), y - 4, x(t), y + 4, end);
      });
      const [low] = this.brackets(step)[step];
      pen.dot(x(low), 110 - 110 * this.gap(low), 'dot', 4);
      pen.say(62, 28, 'gap d(t)');
      pen.say(75, 128, 'apart');
      pen.say(555, 102, 'overlap', '', 'end');
      pen.say(60, 295, 'start of the step');
      pen.say(540, 295, 'end of the step', '', 'end');
    },
    say({step}) {
      const [low, high] = this.brackets(step)[step];
      return `After ${step} halvings the impact lies between ${low.toFixed(4)} and ${high.toFixed(4)} of the step; ` +
        'the left end, where the bodies are apart, is kept.';
    },
  },

  // Baraff's method on two planks: the steps that were computed, from the table of the figure. cmake/site adds the rows.
  index_sets: {
    rows: '',
    box: '0 0 620 190',
    controls: [{name: 'step', steps: true, low: 1, high: 9, step: 1, value: 1, text: 'step'}],
    ready() { return this.rows !== ''; },
    of(step) {
      return this.rows.split(' ').map(row => row.split(',').map(Number)).filter(([number]) => number === step);
    },
    draw(pen, {step}) {
      const x = m => 170 + 130 * m, y = m => 180 - 190 * m;
      const plank = (cx, cy, wide, tall) => pen.shape(corners([x(cx), y(cy)], [65 * wide, 95 * tall], 0));
      for (const [cx, tall] of [[-0.75, 0.5], [0.25, 0.5], [1.5, 0.6]]) plank(cx, tall / 2, 0.1, tall);
      plank(0, 0.55, 2, 0.1);
      plank(1.625, 0.65, 2.5, 0.1);
      const places = [[-0.75, 0.5], [0.25, 0.5], [0.375, 0.6], [1, 0.6], [1.5, 0.6]];
      for (const [, contact, state] of this.of(step)) {
        const [cx, cy] = places[contact - 1];
        pen.dot(x(cx), y(cy), ['unseen', 'driven', 'dot', 'open'][state], 7);
        pen.say(x(cx), y(cy) - 14, contact, '', 'middle');
      }
    },
    say({step}) {
      const rows = this.of(step), list = wanted => rows.filter(([, , state]) => state === wanted).map(row => row[1]);
      const name = (word, all) => all.length ? `${word} ${all.join(', ')}` : '';
      const [, contact, , how] = rows.find(row => row[3] > 0);
      const ends = ['', 'comes to rest', 'stops pushing and leaves the set', 'begins to sink and pushes again'][how];
      return [name('Push:', list(2)), name('driven (orange):', list(1)), name('separate (ring):', list(3))]
        .filter(Boolean).join('; ') + `. The step ends when ${contact} ${ends}.`;
    },
  },
};
})();
