// What is seen of one simulation: boxes, ground, overlays, and a camera that a hand turns.
//
// import {View, aim, COLOURS, legend, overlayLegend} from './view.js';
//
//   aim(ray, speed, gravity)  the velocity [m/s, array of 3] with which a box thrown from ray.origin passes
//       through ray.point, on the flatter of the two ballistic paths; straight at it if that is out of reach.
//       speed [m/s]; gravity [m/s^2] array of 3, (0, -9.81, 0) if it is left out.
//   COLOURS  {boxes: 'Boxes', stable: 'Geometrically stable', ...}: modes of colouring, and their names.
//   legend(mode, dark)  [{colour: '#rrggbb', text}] in the order of reading; for 'overlap' the first is the
//       start of a scale and the second its end.
//   overlayLegend(dark)  the same for contacts, forces and pivots, with
//       {sign: 'dot'|'ring'|'hollow'|'flash'|'arrow'|'line'}.
//
// class View
//   new View(canvas, {onThrow, onTake, onCamera, onLost, onRestored})
//       onThrow(ray): a click or tap without a drag. ray = {origin, direction, point, id}: arrays of 3; point
//           is what was clicked, id the body there, or undefined (ground, sky). Give it to aim().
//       onTake(id): Shift and a click, or a long press, on a box.
//       onCamera(): a person has moved the camera (links: read cameraText()). Not called by resetCamera().
//       onLost(sentence), onRestored(): the drawing context is lost, or is there again.
//       Throws Error with a sentence if there is no WebGL.
//   setScene({ground, fit})  ground: whether there is one (true if left out). fit: the bodies to fit the
//       camera to (frame.slots[0].bodies at the start); without it the camera stays where it is.
//   show(bodies, contacts, alpha, options)  draws at once: call it in requestAnimationFrame. bodies and
//       contacts are those of the last fresh frame, the same arrays again as long as there is no newer one
//       (flashes of collisions are taken from an array that was not seen before).
//       options: {colour: a key of COLOURS, contacts: bool, normals: bool,
//                 forces: bool (true if left out; needs contacts), pivots: bool,
//                 forceScale: [m/N] or undefined for automatic (largest force = edge of a typical box),
//                 time: [s] numbers' `time` of the same frame, dt: [s] the step, playing: bool}
//   scales       {force: [m/N], impulse: [m/(N s)]} lengths of the arrows as last drawn, for a legend
//   gridSpacing  [m] of the finer lines on the ground
//   thrownEdge   [m] edge of the next box that is thrown, to be set: ray.origin keeps clear of what is there
//   rayAt(x, y)  the ray of a point of the canvas [CSS px], or of its middle: for throws by keyboard
//   orbit(dx, dy)  turns [rad]; zoom(factor): nearer above 1; pan(dx, dy): shares of the picture's height
//   resetCamera()  fits the camera to the scene again
//   cameraText()   'px,py,pz,tx,ty,tz' for a link; '' when it is the fitted one. setCameraText(text) takes it
//       ('' fits it again); throws Error with a sentence if it is none.
//   linkCamera(other)  from now on both have one camera pose, that of `this` at first
//   resize()     after the canvas has another size on the page; called by itself through a ResizeObserver too
//   setDark(bool)  overrides prefers-color-scheme; undefined follows it again. dark: what it is now
//   quality      'full', 'no shadows' or 'coarse': goes down by itself while drawing is slow
//   frames       count of drawn frames
//   dispose()    gives everything back; the canvas cannot be used again
//
// For a page that is scrolled by touch, set canvas.style.touchAction after the View is made.
import {Color, Scene, Vector3, WebGLRenderer} from 'three';
import {startOfThrow} from './view_aim.js';
import {Boxes} from './view_boxes.js';
import {Camera} from './view_camera.js';
import {theme} from './view_colours.js';
import {Ground} from './view_ground.js';
import {Overlays} from './overlays.js';
import {listen} from './view_pointer.js';

export {aim} from './view_aim.js';
export {COLOURS, legend, overlayLegend} from './view_colours.js';

const NO_WEBGL = 'This browser gives no WebGL 2 to draw with: turn on hardware acceleration in its ' +
                 'settings, or open the page in another browser.';
const LOST = 'The browser has taken the drawing context away: wait a moment, or reload the page.';

const QUALITIES = ['full', 'no shadows', 'coarse'];
const SLOW = 30;  // [ms] from one drawn frame to the next chance to draw, above which quality goes down
const RETRY = 60e3;  // [ms] after which a new scene is tried with all of it again
const MOST_RATIO = 2;  // drawn pixels for one CSS pixel
const NOTHING = new Float64Array(0);

export class View {
  constructor(canvas, {onThrow, onTake, onCamera, onLost, onRestored} = {}) {
    const context = canvas.getContext('webgl2', {antialias: true, alpha: false});
    if (!context) throw new Error(NO_WEBGL);
    Object.assign(this, {canvas, thrownEdge: 1, frames: 0, slowness: 0, level: 0, lost: false, share: 1,
                         bodies: NOTHING, contacts: NOTHING, options: {}, middle: new Vector3()});
    this.renderer = new WebGLRenderer({canvas, context});
    this.renderer.shadowMap.enabled = true;
    this.scene = new Scene();
    this.scene.background = new Color();
    this.boxes = new Boxes(this.scene);
    this.ground = new Ground(this.scene);
    this.overlays = new Overlays(this.scene);
    this.camera = new Camera(canvas, byHand => {
      this.redraw();
      if (byHand && onCamera) onCamera();
    });
    this.boxes.keepInSight(this.middle, [this.camera.eye.position, this.ground.light]);

    const unlisten = listen(canvas, event => {
      if (onThrow) onThrow(this.rayAt(...this.placeOf(event)));
    }, event => {
      const {id} = this.rayAt(...this.placeOf(event));
      if (onTake && id !== undefined) onTake(id);
    });
    const lose = event => {
      event.preventDefault();  // or it would never be given back
      this.lost = true;
      if (onLost) onLost(LOST);
    };
    const restore = () => {
      this.lost = false;
      this.draw();
      if (onRestored) onRestored();
    };
    canvas.addEventListener('webglcontextlost', lose);
    canvas.addEventListener('webglcontextrestored', restore);
    this.prefers = matchMedia('(prefers-color-scheme: dark)');
    const follow = () => this.setDark(this.chosen);
    this.prefers.addEventListener('change', follow);
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(canvas);
    this.end = () => {
      unlisten();
      canvas.removeEventListener('webglcontextlost', lose);
      canvas.removeEventListener('webglcontextrestored', restore);
      this.prefers.removeEventListener('change', follow);
      this.observer.disconnect();
    };
    this.setDark(undefined);
    this.setScene({fit: NOTHING});
    this.resize();
  }

  setScene({ground = true, fit}) {
    this.hasGround = ground;
    this.measured = false;
    this.contacts = NOTHING;
    this.shownAt = undefined;
    if (fit) this.measure(fit, true);
    if (this.level > 0 && performance.now() - this.levelSince > RETRY) this.setLevel(0);
  }

  // Fits ground, light and overlays to what is there, and the camera if it moves.
  measure(bodies, moves) {
    const {middle, radius, edge} = this.camera.take(bodies, this.hasGround, moves);
    this.middle.copy(middle);
    this.ground.fit(middle, radius, this.hasGround);
    this.overlays.fit(edge, this.hasGround);
    this.measured = true;
  }

  show(bodies, contacts, alpha, options = {}) {
    const now = performance.now();
    const {boxes, overlays} = this;
    if (!this.measured) this.measure(bodies, false);
    const fresh = bodies !== this.bodies || options.colour !== this.options.colour;
    // Flashes fade by the clock while it plays, and by simulated time when it is stepped by hand.
    const clock = options.playing ? Math.min(0.1, (now - this.shownAt) * 1e-3 || 0) : 0;
    const passed = Math.max(clock, options.time - this.options.time || 0);
    this.shownAt = now;
    Object.assign(this, {bodies, contacts: contacts ?? NOTHING, options});
    if (fresh) {
      boxes.take(bodies);
      boxes.paint(options.colour);
    }
    this.share = options.contacts ? overlays.shareOf(this.contacts, alpha, options) : alpha;
    boxes.place(this.share);
    overlays.update(boxes, this.share, this.contacts, options, passed);
    this.draw();
    this.watch();
  }

  // Draws what there is, as soon as the browser draws.
  redraw() {
    this.pending ??= requestAnimationFrame(() => {
      if (this.boxes.hasFixed) this.boxes.place(this.share);  // walls come and go with the camera
      this.draw();
    });
  }

  draw() {
    if (this.pending) cancelAnimationFrame(this.pending);
    this.pending = undefined;
    if (this.lost) return;
    this.renderer.render(this.scene, this.camera.eye);
    this.frames += 1;
  }

  // Goes to a lower quality if frames are slow: the browser offers the next one late if the last is not done.
  watch() {
    if (this.watching || this.level === QUALITIES.length - 1) return;
    this.watching = true;
    const began = performance.now();
    requestAnimationFrame(() => {
      this.watching = false;
      const took = performance.now() - began;
      // Of about the last half second; a single long one, as after a time unseen, is no sign.
      this.slowness += Math.min(0.15, took / 500) * (Math.min(took, 100) - this.slowness);
      if (this.slowness > SLOW) this.setLevel(this.level + 1);
    });
  }

  setLevel(level) {
    Object.assign(this, {level, slowness: 0, levelSince: performance.now()});
    this.ground.shadows = level === 0;
    this.resize();
  }

  get quality() {
    return QUALITIES[this.level];
  }

  resize() {
    const {canvas, renderer} = this;
    const width = Math.max(1, canvas.clientWidth);
    const height = Math.max(1, canvas.clientHeight);
    const ratio = Math.min(this.quality === 'coarse' ? 1 : MOST_RATIO, devicePixelRatio);
    renderer.setPixelRatio(ratio);
    renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    const {uniforms} = this.overlays;
    uniforms.pixelRatio.value = ratio;
    uniforms.screen.value.set(width * ratio, height * ratio);
    uniforms.pixelsOfUnit.value = height * ratio / (2 * Math.tan(this.camera.eye.fov * Math.PI / 360));
    this.draw();
  }

  setDark(chosen) {
    this.chosen = chosen;
    this.dark = chosen ?? this.prefers.matches;
    this.scene.background.set(theme(this.dark).background);
    this.ground.setDark(this.dark);
    this.overlays.setDark(this.dark);
    this.boxes.painter.setDark(this.dark);
    this.boxes.paint(this.options.colour);
    this.overlays.update(this.boxes, this.share, this.contacts, this.options, 0);
    this.redraw();
  }

  get scales() {
    return this.overlays.scales;
  }

  get gridSpacing() {
    return this.ground.spacing;
  }

  // What is at a point of the canvas, and from where a box is thrown there.
  rayAt(x = this.canvas.clientWidth / 2, y = this.canvas.clientHeight / 2) {
    const {canvas, camera: {eye}, boxes, thrownEdge, hasGround} = this;
    eye.updateMatrixWorld();
    const from = eye.position;
    const way = new Vector3(2 * x / canvas.clientWidth - 1, 1 - 2 * y / canvas.clientHeight, 0.5)
        .unproject(eye).sub(from).normalize();
    const hit = boxes.pick(from.toArray(), way.toArray());
    let {distance} = hit;
    if (hasGround && way.y < 0) distance = Math.min(distance, -from.y / way.y);
    if (distance < Infinity && distance === -from.y / way.y) hit.id = undefined;
    if (distance === Infinity) distance = from.distanceTo(this.middle);  // the sky
    const point = from.clone().addScaledVector(way, distance);

    const below = new Vector3(0, -1, 0).applyQuaternion(eye.quaternion);
    const origin = startOfThrow(from.toArray(), way.toArray(), below.toArray(), distance, {
      edge: thrownEdge, lowest: hasGround ? thrownEdge : -Infinity,
      meets: at => boxes.touches(at, thrownEdge),
    });
    return {origin, direction: way.toArray(), point: point.toArray(), id: hit.id};
  }

  placeOf({clientX, clientY}) {
    const {left, top} = this.canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  orbit(dx, dy) {
    this.camera.controls.rotateLeft(dx);
    this.camera.controls.rotateUp(dy);
  }

  zoom(factor) {
    this.camera.controls.dollyIn(1 / factor);
  }

  pan(dx, dy) {
    const {clientHeight} = this.canvas;
    this.camera.controls.pan(dx * clientHeight, dy * clientHeight);
  }

  resetCamera() {
    this.camera.fit();
  }

  cameraText() {
    return this.camera.text;
  }

  setCameraText(text) {
    this.camera.text = text;
  }

  linkCamera(other) {
    this.camera.link(other.camera);
  }

  dispose() {
    this.end();
    if (this.pending) cancelAnimationFrame(this.pending);
    for (const part of [this.boxes, this.ground, this.overlays, this.camera, this.renderer]) part.dispose();
    this.renderer.forceContextLoss();
  }
}
