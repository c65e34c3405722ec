// What is drawn over the boxes: contact points with normals and forces, flashes of collisions, pivots.
import {Color, Quaternion, Vector2, Vector3} from 'three';
import {BODY, CONTACT, KIND} from './module.js';
import {theme} from './view_colours.js';
import {Dots, FAINT, Lines, SHAPE} from './view_marks.js';

const COLLISION = 3;  // state of a contact that is an event
const SHAPES = [SHAPE.dot, SHAPE.ring, SHAPE.hollow];  // by state: sticks, slips, open
const FLASH = 0.3;  // [s] until a collision has faded
const MOST_FLASHES = 512;  // at a time; the eldest go
const LEAST = 0.01;  // of the largest impulse: what is smaller does not flash
const CALM = 0.97;  // per step, by which the largest push is forgotten: arrows keep their scale a while
const CLEAR = 250;  // of more contacts, those that boxes hide fade, or nothing else would be seen
const OLD = 0.25;  // of a step: points between two bodies that are older than the newest are not drawn
const NORMAL = 0.35;  // length of a normal, in typical edges

export class Overlays {
  constructor(scene) {
    this.uniforms = {
      edge: {value: 1}, pixelsOfUnit: {value: 1}, pixelRatio: {value: 1}, screen: {value: new Vector2(1, 1)},
      halo: {value: new Color()},
    };
    this.lines = new Lines(scene, this.uniforms);
    this.dots = new Dots(scene, this.uniforms);
    this.colours = {ink: new Color(), force: new Color(), normal: new Color(), impulse: new Color(),
                    pivot: new Color()};
    this.flashes = new Float64Array(7 * MOST_FLASHES);  // point, impulse, age [s]
    this.latest = new Map();  // time of the newest points between two bodies
    this.point = new Vector3();
    this.turn = new Quaternion();
    this.turned = new Float64Array(4);
    this.scales = {force: 0, impulse: 0};
    this.fit(1, false);
  }

  setDark(dark) {
    const t = theme(dark);
    this.uniforms.halo.value.set(t.halo);
    for (const [name, colour] of Object.entries(this.colours)) colour.set(t[name]);
  }

  // Starts afresh; edge: of a typical box [m]. The ground is the first body in contacts, and none in bodies.
  fit(edge, hasGround) {
    this.edge = this.uniforms.edge.value = edge;
    this.firstBox = hasGround ? 1 : 0;
    this.largestForce = 0;
    this.largestImpulse = 0;
    this.flashCount = 0;  // in all: the place of the next one is its rest by MOST_FLASHES
    this.drawn = undefined;
  }

  // The share of the step at which the contact points are where they were found; alpha if there are none.
  shareOf(contacts, alpha, {time, dt}) {
    let latest = -Infinity;
    for (let at = 0; at < contacts.length; at += CONTACT.size)
      if (contacts[at + CONTACT.state] !== COLLISION) latest = Math.max(latest, contacts[at + CONTACT.time]);
    if (latest === -Infinity || !(dt > 0) || !(time >= 0)) return alpha;
    return Math.min(1, Math.max(0, (latest - time + dt) / dt));
  }

  // share: of the step, at which the boxes are drawn; passed [s]: for which flashes have faded since.
  update(boxes, share, contacts, options, passed) {
    this.lines.clear();
    this.dots.clear();
    if (options.contacts) {
      if (contacts !== this.drawn) this.take(contacts, options);
      this.drawn = contacts;
      this.scales.force = options.forceScale > 0 ? options.forceScale : this.edge / (this.largestForce || 1);
      this.scales.impulse = this.edge / (this.largestImpulse || 1);
      this.addContacts(boxes, share, contacts, options);
      this.addFlashes(passed);
    }
    if (options.pivots) this.addPivots(boxes);
    this.lines.finish();
    this.dots.finish();
  }

  // Looks at the contacts of a newer step: how large they are, and which collisions flash.
  take(contacts, {dt}) {
    const {latest} = this;
    this.largestForce *= CALM;
    this.largestImpulse *= CALM;
    latest.clear();
    for (let at = 0; at < contacts.length; at += CONTACT.size) {
      const push = lengthOf(contacts, at + CONTACT.push);
      if (contacts[at + CONTACT.state] === COLLISION) {
        this.largestImpulse = Math.max(this.largestImpulse, push);
        continue;
      }
      this.largestForce = Math.max(this.largestForce, push * forceOf(contacts, at, dt));
      const pair = pairOf(contacts, at);
      latest.set(pair, Math.max(latest.get(pair) ?? -Infinity, contacts[at + CONTACT.time]));
    }
    // What is small beside what a step of resting gives is no collision to a reader.
    if (dt > 0) this.largestImpulse = Math.max(this.largestImpulse, this.largestForce * dt);
    for (let at = 0; at < contacts.length; at += CONTACT.size)
      if (contacts[at + CONTACT.state] === COLLISION) this.addFlash(contacts, at);
  }

  addFlash(contacts, at) {
    if (lengthOf(contacts, at + CONTACT.push) < LEAST * this.largestImpulse) return;
    const to = 7 * (this.flashCount++ % MOST_FLASHES);
    const sign = upwards(contacts, at);
    for (let k = 0; k < 3; ++k) {
      this.flashes[to + k] = contacts[at + CONTACT.point + k];
      this.flashes[to + 3 + k] = sign * contacts[at + CONTACT.push + k];
    }
    this.flashes[to + 6] = 0;
  }

  addContacts(boxes, share, contacts, {normals, forces = true, time, dt}) {
    const {lines, dots, colours, edge, point} = this;
    const faint = FAINT * Math.min(1, CLEAR * CONTACT.size / contacts.length);
    for (let at = 0; at < contacts.length; at += CONTACT.size) {
      const state = contacts[at + CONTACT.state];
      const found = contacts[at + CONTACT.time];
      // Some techniques find the same points early and late in a step.
      if (state === COLLISION || found < this.latest.get(pairOf(contacts, at)) - OLD * dt) continue;
      point.fromArray(contacts, at + CONTACT.point);
      const then = 1 + (found - time) / dt;
      if (Math.abs(then - share) > 1e-3) this.carry(boxes, this.moverOf(boxes, contacts, at), then);
      const {x, y, z} = point;
      const sign = upwards(contacts, at);
      if (normals) {
        const long = sign * NORMAL * edge;
        lines.add(x, y, z, long * contacts[at + CONTACT.normal], long * contacts[at + CONTACT.normal + 1],
                  long * contacts[at + CONTACT.normal + 2], colours.normal, 1.6, true, 1, faint);
      }
      if (forces) {
        const long = sign * this.scales.force * forceOf(contacts, at, dt);
        const dx = long * contacts[at + CONTACT.push];
        const dy = long * contacts[at + CONTACT.push + 1];
        const dz = long * contacts[at + CONTACT.push + 2];
        if (Math.hypot(dx, dy, dz) > 0.01 * edge)
          lines.add(x, y, z, dx, dy, dz, colours.force, 3, true, 1, faint);
      }
      dots.add(x, y, z, SHAPES[state] ?? SHAPE.hollow, 9, colours.ink, 1, faint);
    }
  }

  addFlashes(passed) {
    const {lines, dots, colours, flashes} = this;
    const count = Math.min(this.flashCount, MOST_FLASHES);
    for (let at = 0; at < 7 * count; at += 7) {
      flashes[at + 6] += passed;
      const left = 1 - flashes[at + 6] / FLASH;
      if (left <= 0) continue;
      const [x, y, z] = [flashes[at], flashes[at + 1], flashes[at + 2]];
      const dx = this.scales.impulse * flashes[at + 3];
      const dy = this.scales.impulse * flashes[at + 4];
      const dz = this.scales.impulse * flashes[at + 5];
      const size = 12 + 26 * Math.sqrt(Math.min(1, Math.hypot(dx, dy, dz) / this.edge));
      dots.add(x, y, z, SHAPE.flash, size, colours.impulse, left);
      lines.add(x, y, z, dx, dy, dz, colours.impulse, 3, true, left);
    }
  }

  // The place in bodies of one that moves, of the two of a contact.
  moverOf({bodies}, contacts, at) {
    const second = contacts[at + CONTACT.second] - this.firstBox;
    const fixed = bodies[second * BODY.size + BODY.kind] & KIND.fixed;
    return fixed ? contacts[at + CONTACT.first] - this.firstBox : second;
  }

  // Carries `point` with a box from where it was at a share of the step to where it is drawn.
  carry({bodies, poses, count}, k, then) {
    if (k < 0 || k >= count || !(then >= 0 && then <= 1)) return;
    const {point, turn} = this;
    const at = k * BODY.size;
    const {before, now} = BODY;
    for (let i = 0; i < 3; ++i) {
      const from = bodies[at + before + i];
      point.setComponent(i, point.getComponent(i) - from - then * (bodies[at + now + i] - from));
    }
    Quaternion.slerpFlat(this.turned, 0, bodies, at + before + 3, bodies, at + now + 3, then);
    point.applyQuaternion(turn.fromArray(this.turned).conjugate());
    point.applyQuaternion(turn.fromArray(poses, 7 * k + 3));
    for (let i = 0; i < 3; ++i) point.setComponent(i, point.getComponent(i) + poses[7 * k + i]);
  }

  // A pivot is known where its body is now, and is carried along to where the body is drawn.
  addPivots({bodies, poses, count}) {
    const {lines, dots, colours, point, turn} = this;
    for (let k = 0; k < count; ++k) {
      const at = k * BODY.size;
      if (!(bodies[at + BODY.pivot] === bodies[at + BODY.pivot])) continue;  // not a number: it has none
      for (let i = 0; i < 3; ++i)
        point.setComponent(i, bodies[at + BODY.pivot + i] - bodies[at + BODY.now + i]);
      point.applyQuaternion(turn.fromArray(bodies, at + BODY.now + 3).conjugate());
      point.applyQuaternion(turn.fromArray(poses, 7 * k + 3));
      const [x, y, z] = [poses[7 * k], poses[7 * k + 1], poses[7 * k + 2]];
      lines.add(x, y, z, point.x, point.y, point.z, colours.pivot, 2, false, 1, 0.8);
      dots.add(x, y, z, SHAPE.dot, 6, colours.pivot, 1, 0.8);
      dots.add(x + point.x, y + point.y, z + point.z, SHAPE.diamond, 13, colours.pivot, 1, 0.8);
    }
  }

  dispose() {
    this.lines.dispose();
    this.dots.dispose();
  }
}

// By what a push becomes a force: some techniques know the impulse of a whole step.
function forceOf(contacts, at, dt) {
  return contacts[at + CONTACT.impulse] !== 0 && dt > 0 ? 1 / dt : 1;
}

const lengthOf = (numbers, at) => Math.hypot(numbers[at], numbers[at + 1], numbers[at + 2]);

const pairOf = (contacts, at) => contacts[at + CONTACT.first] * 1e6 + contacts[at + CONTACT.second];

// 1, or -1 where the first body is the upper one: arrows show what the upper one feels.
function upwards(contacts, at) {
  return contacts[at + CONTACT.normal + 1] < -1e-3 ? -1 : 1;
}
