// The camera: fitted to a scene, turned by hand or by key, written as a short text, shared by two views.
import {PerspectiveCamera, Vector3} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {BODY, KIND} from './module.js';

const ANGLE = 32;  // [degrees] of the picture's height
const FROM = new Vector3(0.34, 0.27, 1).normalize();  // where it stands at first, seen from the middle
const MARGIN = 1.12;  // room around the boxes

export class Camera {
  // onMove(byHand): the pose is another one.
  constructor(canvas, onMove) {
    this.onMove = onMove;
    this.eye = new PerspectiveCamera(ANGLE, 1, 0.1, 1000);
    this.controls = new OrbitControls(this.eye, canvas);
    this.controls.rotateSpeed = 0.7;
    this.quiet = false;  // a change that no hand made
    this.home = '';
    this.middle = new Vector3();
    this.low = new Vector3(-1, 0, -1);
    this.high = new Vector3(1, 2, 1);
    this.corner = new Vector3();
    this.right = new Vector3();
    this.up = new Vector3();
    this.controls.addEventListener('change', () => this.changed(!this.quiet));
  }

  changed(byHand) {
    this.onMove(byHand);
    if (this.other) this.other.follow(this);
  }

  follow({eye, controls}) {
    this.eye.position.copy(eye.position);
    this.controls.target.copy(controls.target);
    const {other} = this;
    this.other = undefined;  // not back again
    this.update();
    this.other = other;
  }

  update() {
    this.quiet = true;
    this.controls.update();
    this.quiet = false;
  }

  // Both have the pose of this one from now on.
  link(other) {
    this.other = other;
    other.other = this;
    other.follow(this);
  }

  unlink() {
    if (this.other) this.other.other = undefined;
    this.other = undefined;
  }

  // Finds the space that the movable boxes are in, with what there is of fixed ones and of the ground nearby.
  // moves: whether it goes there. {middle, radius, edge}; edge: of a cube as large as a typical box.
  take(bodies, hasGround, moves) {
    const {low, high} = this;
    low.setScalar(Infinity);
    high.setScalar(-Infinity);
    const sizes = [];  // edges of cubes as large as the boxes
    const each = (fixed, seen) => {
      for (let at = 0; at < bodies.length; at += BODY.size)
        if (((bodies[at + BODY.kind] & KIND.fixed) !== 0) === fixed)
          seen(at, bodies.subarray(at + BODY.edges, at + BODY.edges + 3));
    };
    each(false, (at, edges) => {
      sizes.push(Math.cbrt(edges[0] * edges[1] * edges[2]));
      const reach = Math.hypot(...edges) / 2 * 0.8;
      for (let k = 0; k < 3; ++k) {
        const x = bodies[at + BODY.now + k];
        low.setComponent(k, Math.min(low.getComponent(k), x - reach));
        high.setComponent(k, Math.max(high.getComponent(k), x + reach));
      }
    });
    if (sizes.length === 0) {  // nothing moves
      low.set(-1, 0, -1);
      high.set(1, 2, 1);
      sizes.push(1);
    }
    sizes.sort((one, other) => one - other);
    if (hasGround) low.y = Math.max(0, Math.min(low.y, 0));
    // A few boxes go a way: they get room for it.
    const room = Math.max(0, 1.9 * sizes[sizes.length - 1] - 0.5 * low.distanceTo(high));
    low.x -= room;
    high.x += room;
    low.z -= room / 2;
    high.z += room / 2;
    high.y += 0.6 * room;
    if (!hasGround) low.y -= 0.6 * room;
    const near = 0.5 * low.distanceTo(high);
    const [lowest, highest] = [low.clone().subScalar(near), high.clone().addScalar(near)];
    each(true, (at, edges) => {
      for (let k = 0; k < 3; ++k) {
        const x = bodies[at + BODY.now + k];
        const long = Math.max(...edges) > 4 * near ? 0 : edges[k] / 2;
        low.setComponent(k, Math.min(low.getComponent(k), Math.max(x - long, lowest.getComponent(k))));
        high.setComponent(k, Math.max(high.getComponent(k), Math.min(x + long, highest.getComponent(k))));
      }
    });
    if (hasGround) low.y = Math.max(0, low.y);
    this.middle.addVectors(low, high).multiplyScalar(0.5);
    const radius = 0.5 * low.distanceTo(high);
    this.eye.near = 0.01 * radius;
    this.eye.far = 200 * radius;
    this.controls.minDistance = 0.1 * radius;
    this.controls.maxDistance = 30 * radius;
    this.controls.maxPolarAngle = hasGround ? 0.497 * Math.PI : Math.PI;  // not below the ground
    this.eye.updateProjectionMatrix();
    const stay = [...this.eye.position.toArray(), ...this.controls.target.toArray()];
    this.fit();
    if (!moves) this.go(stay);
    return {middle: this.middle, radius, edge: sizes[sizes.length >> 1]};
  }

  // Goes as near as the boxes' space is all in the picture.
  fit() {
    const {eye, controls, middle, low, high, corner, right, up} = this;
    right.set(0, 1, 0).cross(FROM).normalize();
    up.copy(FROM).cross(right);
    const tall = Math.tan(eye.fov * Math.PI / 360) / MARGIN;
    const wide = tall * eye.aspect;
    let distance = 0;
    for (let k = 0; k < 8; ++k) {
      corner.set((k & 1 ? high : low).x, (k & 2 ? high : low).y, (k & 4 ? high : low).z).sub(middle);
      const ahead = corner.dot(FROM);
      const needed = Math.max(Math.abs(corner.dot(right)) / wide, Math.abs(corner.dot(up)) / tall);
      distance = Math.max(distance, ahead + needed);
    }
    eye.position.copy(middle).addScaledVector(FROM, distance);
    controls.target.copy(middle);
    this.update();
    this.home = this.pose();
    this.changed(false);
  }

  resize(width, height) {
    const fitted = this.pose() === this.home;
    this.eye.aspect = width / height;
    this.eye.updateProjectionMatrix();
    if (fitted) this.fit();
  }


  pose() {
    const {eye: {position}, controls: {target}} = this;
    const digits = Math.max(0, 3 - Math.floor(Math.log10(position.distanceTo(target))));
    return [...position.toArray(), ...target.toArray()].map(x => +x.toFixed(digits) + 0).join(',');
  }

  get text() {
    const pose = this.pose();
    return pose === this.home ? '' : pose;
  }

  set text(text) {
    if (text === '') return this.fit();
    const numbers = text.split(',').map(word => (word.trim() === '' ? NaN : Number(word)));
    const far = 1e6;
    if (numbers.length !== 6 || !numbers.every(x => Math.abs(x) < far) ||
        Math.hypot(...[0, 1, 2].map(k => numbers[k] - numbers[k + 3])) === 0)
      throw new Error(`camera=${text}: expected six numbers with commas, where it is and what it looks at, ` +
                      'such as 4,5,18,0,3,0.');
    this.go(numbers);
  }

  go(pose) {
    this.eye.position.fromArray(pose);
    this.controls.target.fromArray(pose, 3);
    this.update();
    this.changed(false);
  }

  dispose() {
    this.unlink();
    this.controls.dispose();
  }
}
