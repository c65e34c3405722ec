// Marks of a few pixels over the picture: arrows and lines, points of several kinds. Each is one call of
// drawing for what is in sight and one, faint, for what is hidden by boxes.
import {BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, GreaterDepth, InstancedBufferAttribute,
  InstancedBufferGeometry, LessEqualDepth, Mesh, Points, ShaderMaterial} from 'three';
import {send} from './view_boxes.js';

export const FAINT = 0.22;  // what boxes hide, of what is in sight
export const SHAPE = {dot: 0, ring: 1, hollow: 2, flash: 3, diamond: 4};

// Drawn a little nearer to the eye than they are, so that marks on a surface lie on it.
const common = `
uniform float edge, pixelsOfUnit, pixelRatio;
uniform bool hidden;
vec4 seen(vec3 at) {
  vec4 view = viewMatrix * vec4(at, 1.0);
  view.xyz *= 1.0 - 0.04 * edge / max(length(view.xyz), 0.05 * edge);
  return view;
}
// Length on the screen of the scene's shortest edge there [pixels].
float edgePixels(vec4 view) { return edge * pixelsOfUnit / max(-view.z, 1e-6); }`;

const lineVertex = `${common}
attribute vec3 from, to, tint;
attribute vec4 shape;  // width [CSS pixels], whether it has a head, opacity in sight, hidden
uniform vec2 screen;
varying vec4 vColour;
uniform vec3 halo;
// position: x along the line (0 its start, 1 where the head begins, 2 its tip), y across (1: half the width,
// 2: half the head), z whether it belongs to the halo.
void main() {
  vec4 a = seen(from), b = seen(to);
  float near = -0.02 * edge;  // what is behind the eye is cut off
  if (a.z > near && b.z > near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (a.z > near) a = mix(b, a, (near - b.z) / (a.z - b.z));
  if (b.z > near) b = mix(a, b, (near - a.z) / (b.z - a.z));
  float thick = clamp(edgePixels(a) / 40.0, 0.45, 1.0) * pixelRatio;
  vec4 first = projectionMatrix * a, last = projectionMatrix * b;
  vec2 way = (last.xy / last.w - first.xy / first.w) * 0.5 * screen;
  float pixels = length(way);
  vec2 ahead = pixels > 1e-3 ? way / pixels : vec2(0.0, 1.0);
  float width = shape.x * thick;
  float head = shape.y * min(4.0 * width, 0.55 * pixels);
  vec4 place = position.x < 0.5 ? first : last;
  float back = position.x > 0.5 && position.x < 1.5 ? -head : 0.0;
  float across = abs(position.y) < 1.5 ? 0.5 * width : 0.45 * head;
  float rim = position.z * 1.1 * pixelRatio;
  float ends = position.x < 0.5 ? -rim : position.x > 1.5 ? 2.0 * rim : abs(position.y) > 1.5 ? -rim : 0.0;
  if (across > 0.0) across += rim;
  vec2 shift = ahead * (back + ends) + vec2(-ahead.y, ahead.x) * sign(position.y) * across;
  gl_Position = place;
  gl_Position.xy += shift * 2.0 / screen * place.w;
  float opacity = (hidden ? shape.w : shape.z) * mix(1.0, 0.75, position.z);
  vColour = vec4(mix(tint, halo, position.z), opacity);
}`;

const lineFragment = `
varying vec4 vColour;
void main() {
  gl_FragColor = vec4(vColour.rgb, vColour.a);
  #include <colorspace_fragment>
}`;

const pointVertex = `${common}
attribute vec3 tint;
attribute vec4 shape;  // which, diameter [CSS pixels], opacity in sight, hidden
varying vec4 vColour;
varying vec2 vShape;  // which, radius [pixels]
void main() {
  vec4 view = seen(position);
  float size = shape.y * pixelRatio * clamp(edgePixels(view) / 60.0, 0.45, 1.0);
  gl_Position = projectionMatrix * view;
  gl_PointSize = size + 4.0 * pixelRatio;
  vShape = vec2(shape.x, 0.5 * size);
  vColour = vec4(tint, hidden ? shape.w : shape.z);
}`;

const pointFragment = `
uniform float pixelRatio;
uniform vec3 halo;
varying vec4 vColour;
varying vec2 vShape;
float within(float distance) { return clamp(0.5 - distance, 0.0, 1.0); }  // share of the pixel
void main() {
  float radius = vShape.y;
  vec2 at = (gl_PointCoord - 0.5) * (2.0 * radius + 4.0 * pixelRatio);
  float away = length(at) - radius;
  float line = 0.75 * pixelRatio;
  float ink = within(away);
  float rim = within(away - 1.2 * pixelRatio);
  float alpha = vColour.a;
  if (vShape.x > 3.5) {  // diamond
    away = (abs(at.x) + abs(at.y)) * 0.7071 - 0.8 * radius;
    ink = within(away);
    rim = within(away - 1.2 * pixelRatio);
  } else if (vShape.x > 2.5) {  // flash: a disc that is brightest inside
    rim = 0.0;
    ink *= mix(1.0, 0.35, length(at) / radius);
  } else if (vShape.x > 1.5) {  // hollow
    ink = within(abs(away + line) - line);
    rim = ink;
    alpha *= 0.75;
  } else if (vShape.x > 0.5) {  // ring
    ink = within(abs(away + 1.3 * line) - 1.3 * line);
  }
  float cover = max(ink, rim);
  if (cover <= 0.0) discard;
  gl_FragColor = vec4(mix(halo, vColour.rgb, ink / cover), alpha * cover);
  #include <colorspace_fragment>
}`;

// The corners of an arrow: its halo first, then itself.
function arrow() {
  const corners = [];
  const order = [];
  for (const halo of [1, 0]) {
    const at = corners.length / 3;
    corners.push(0, -1, halo, 0, 1, halo, 1, -1, halo, 1, 1, halo, 1, -2, halo, 1, 2, halo, 2, 0, halo);
    order.push(0, 2, 1, 1, 2, 3, 4, 6, 5);
    for (let k = order.length - 9; k < order.length; ++k) order[k] += at;
  }
  return {corners: new Float32Array(corners), order};
}

// Numbers of many marks, in attributes that grow.
class Marks {
  constructor(geometry, Attribute, sizes) {
    this.geometry = geometry;
    this.Attribute = Attribute;
    this.sizes = sizes;  // {name: numbers of one}
    this.count = 0;
    this.reserve(512);
  }

  reserve(capacity) {
    this.capacity = capacity;
    this.geometry.dispose();  // what the graphics processor had of it
    for (const [name, size] of Object.entries(this.sizes)) {
      const old = this.geometry.attributes[name];
      const attribute = new this.Attribute(new Float32Array(capacity * size), size);
      attribute.setUsage(DynamicDrawUsage);
      if (old) attribute.array.set(old.array);
      this.geometry.setAttribute(name, attribute);
    }
  }

  next() {
    if (this.count === this.capacity) this.reserve(2 * this.capacity);
    return this.count++;
  }

  finish() {
    for (const name in this.sizes) send(this.geometry.attributes[name], this.sizes[name] * this.count);
  }
}

function materials(uniforms, vertexShader, fragmentShader) {
  return [GreaterDepth, LessEqualDepth].map(depthFunc => new ShaderMaterial({
    uniforms: {...uniforms, hidden: {value: depthFunc === GreaterDepth}},  // the others are shared
    vertexShader, fragmentShader, depthFunc, side: DoubleSide, transparent: true, depthWrite: false,
  }));
}

function add(scene, Kind, geometry, both, order) {
  both.forEach((material, k) => {
    const object = new Kind(geometry, material);
    object.frustumCulled = false;
    object.renderOrder = order + 10 * k;
    scene.add(object);
  });
}

export class Lines {
  constructor(scene, uniforms) {
    const {corners, order} = arrow();
    this.geometry = new InstancedBufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(corners, 3));
    this.geometry.setIndex(order);
    this.marks = new Marks(this.geometry, InstancedBufferAttribute, {from: 3, to: 3, shape: 4, tint: 3});
    this.materials = materials(uniforms, lineVertex, lineFragment);
    add(scene, Mesh, this.geometry, this.materials, 10);
    this.clear();
  }

  clear() {
    this.marks.count = 0;
  }

  // From (x, y, z) by (dx, dy, dz); width [CSS pixels]; hidden: opacity where boxes hide it.
  add(x, y, z, dx, dy, dz, colour, width, head, opacity = 1, hidden = FAINT * opacity) {
    const place = this.marks.next();
    const at = 3 * place;
    const {from, to, shape, tint} = this.geometry.attributes;
    write(from.array, at, x, y, z);
    write(to.array, at, x + dx, y + dy, z + dz);
    write4(shape.array, 4 * place, width, head ? 1 : 0, opacity, hidden);
    write(tint.array, at, colour.r, colour.g, colour.b);
  }

  finish() {
    this.geometry.instanceCount = this.marks.count;
    this.marks.finish();
  }

  dispose() {
    this.geometry.dispose();
    this.materials.forEach(material => material.dispose());
  }
}

export class Dots {
  constructor(scene, uniforms) {
    this.geometry = new BufferGeometry();
    this.marks = new Marks(this.geometry, BufferAttribute, {position: 3, shape: 4, tint: 3});
    this.materials = materials(uniforms, pointVertex, pointFragment);
    add(scene, Points, this.geometry, this.materials, 11);
    this.clear();
  }

  clear() {
    this.marks.count = 0;
  }

  // shape: one of SHAPE; size: diameter [CSS pixels]; hidden: opacity where boxes hide it.
  add(x, y, z, shape, size, colour, opacity = 1, hidden = FAINT * opacity) {
    const place = this.marks.next();
    const at = 3 * place;
    const {attributes} = this.geometry;
    write(attributes.position.array, at, x, y, z);
    write4(attributes.shape.array, 4 * place, shape, size, opacity, hidden);
    write(attributes.tint.array, at, colour.r, colour.g, colour.b);
  }

  finish() {
    this.geometry.setDrawRange(0, this.marks.count);
    this.marks.finish();
  }

  dispose() {
    this.geometry.dispose();
    this.materials.forEach(material => material.dispose());
  }
}

function write(array, at, a, b, c) {
  array[at] = a;
  array[at + 1] = b;
  array[at + 2] = c;
}

function write4(array, at, a, b, c, d) {
  write(array, at, a, b, c);
  array[at + 3] = d;
}
