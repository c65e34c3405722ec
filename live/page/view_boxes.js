// All boxes in one call of drawing, at poses between two steps.
import {BoxGeometry, DynamicDrawUsage, InstancedBufferAttribute, InstancedMesh, Matrix4, MeshLambertMaterial,
  Quaternion, Vector3} from 'three';
import {BODY, KIND} from './module.js';
import {Painter} from './view_colours.js';
import {distanceToBox, enterBox} from './view_aim.js';

const POSE = 7;  // numbers of one: position, then x y z w

// Lines of about a pixel along the edges of each face, darker than a light box and lighter than a dark one.
function drawEdges(shader) {
  shader.vertexShader = shader.vertexShader
      .replace('void main() {', 'varying vec2 vFace;\nvoid main() {\n  vFace = uv;');
  shader.fragmentShader = shader.fragmentShader
      .replace('void main() {', 'varying vec2 vFace;\nvoid main() {')
      .replace('#include <opaque_fragment>', `
        vec2 pixel = fwidth(vFace);
        vec2 inside = min(vFace, 1.0 - vFace) / max(pixel, 1e-6);
        float edge = 1.0 - smoothstep(0.6, 1.5, min(inside.x, inside.y));
        edge *= 1.0 - smoothstep(0.06, 0.25, max(pixel.x, pixel.y));  // a box of few pixels has none
        float bright = dot(diffuseColor.rgb, vec3(0.21, 0.72, 0.07));
        vec3 line = bright > 0.09 ? 0.22 * diffuseColor.rgb : 2.0 * diffuseColor.rgb + 0.12;
        outgoingLight = mix(outgoingLight, line, 0.85 * edge);
        #include <opaque_fragment>`);
}

export class Boxes {
  constructor(scene) {
    this.scene = scene;
    this.geometry = new BoxGeometry(1, 1, 1);
    this.material = new MeshLambertMaterial();
    this.material.onBeforeCompile = drawEdges;
    this.painter = new Painter();
    this.poses = new Float64Array(0);  // as drawn
    this.count = 0;
    this.hasFixed = false;
    this.hidden = new Set();  // places of fixed boxes that are left out
    this.position = new Vector3();
    this.turn = new Quaternion();
    this.edges = new Vector3();
    this.matrix = new Matrix4();
    this.inward = new Vector3();
    this.outward = new Vector3();
    this.back = new Quaternion();
    this.bodies = new Float64Array(0);
    this.reserve(256);
  }

  reserve(capacity) {
    this.release();
    this.capacity = capacity;
    this.mesh = new InstancedMesh(this.geometry, this.material, capacity);
    this.mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    this.mesh.instanceColor = new InstancedBufferAttribute(new Float32Array(3 * capacity), 3);
    this.mesh.instanceColor.setUsage(DynamicDrawUsage);
    this.mesh.frustumCulled = false;
    this.mesh.castShadow = true;
    this.mesh.receiveShadow = true;
    this.scene.add(this.mesh);
  }

  release() {
    if (!this.mesh) return;
    this.scene.remove(this.mesh);
    this.mesh.dispose();
  }

  // Takes the numbers of a newer step.
  take(bodies) {
    this.bodies = bodies;
    this.count = bodies.length / BODY.size;
    if (this.count > this.capacity) this.reserve(Math.max(this.count, 2 * this.capacity));
    if (this.poses.length < POSE * this.capacity) this.poses = new Float64Array(POSE * this.capacity);
    this.hasFixed = false;
    for (let at = BODY.kind; at < bodies.length && !this.hasFixed; at += BODY.size)
      this.hasFixed = (bodies[at] & KIND.fixed) !== 0;
  }

  paint(mode) {
    const {instanceColor} = this.mesh;
    this.painter.paint(mode, this.bodies, instanceColor.array);
    send(instanceColor, 3 * this.count);
  }

  // Poses at a share of the way from before the last step to now.
  place(share) {
    const {bodies, poses, position, turn, edges, matrix, hidden} = this;
    const {instanceMatrix} = this.mesh;
    hidden.clear();
    for (let k = 0, at = 0, to = 0; k < this.count; ++k, at += BODY.size, to += POSE) {
      const before = at + BODY.before;
      const now = at + BODY.now;
      for (let i = 0; i < 3; ++i)
        poses[to + i] = bodies[before + i] + share * (bodies[now + i] - bodies[before + i]);
      Quaternion.slerpFlat(poses, to + 3, bodies, before + 3, bodies, now + 3, share);
      position.fromArray(poses, to);
      turn.fromArray(poses, to + 3);
      edges.fromArray(bodies, at + BODY.edges);
      if (this.hasFixed && bodies[at + BODY.kind] & KIND.fixed && this.isWall()) {
        hidden.add(k);
        edges.setScalar(0);
      }
      matrix.compose(position, turn, edges).toArray(instanceMatrix.array, 16 * k);
    }
    this.mesh.count = this.count;
    send(instanceMatrix, 16 * this.count);
  }

  // Fixed boxes between the middle of the scene and one of the points `from` will be left out.
  keepInSight(middle, from) {
    Object.assign(this, {middle, from});
  }

  // Whether the fixed box at `position` is in the way: the walls of a cage are.
  isWall() {
    const {position, edges, back, inward, outward} = this;
    back.copy(this.turn).conjugate();
    inward.copy(this.middle).sub(position).applyQuaternion(back);
    for (const from of this.from) {
      outward.copy(from).sub(position).applyQuaternion(back);
      for (const k of 'xyz') {
        const half = edges[k] / 2;
        if (Math.abs(outward[k]) > half && inward[k] * Math.sign(outward[k]) < -half) return true;
      }
    }
    return false;
  }

  // Where a ray meets the first box that is drawn: {distance in lengths of direction, id}.
  pick(origin, direction) {
    const hit = {distance: Infinity, id: undefined};
    for (let k = 0; k < this.count; ++k) {
      if (this.hidden.has(k)) continue;
      const distance = enterBox(origin, direction, ...this.box(k));
      if (distance < hit.distance) {
        hit.distance = distance;
        hit.id = this.bodies[k * BODY.size + BODY.id];
      }
    }
    return hit;
  }

  // Whether a ball meets a box.
  touches(centre, radius) {
    for (let k = 0; k < this.count; ++k)
      if (distanceToBox(centre, ...this.box(k)) < radius) return true;
    return false;
  }

  box(k) {  // centre, turn, half edges: for a click, not for each frame
    const at = k * BODY.size + BODY.edges;
    return [Array.from(this.poses.subarray(POSE * k, POSE * k + 3)),
            Array.from(this.poses.subarray(POSE * k + 3, POSE * k + 7)),
            Array.from(this.bodies.subarray(at, at + 3), edge => edge / 2)];
  }

  dispose() {
    this.release();
    this.geometry.dispose();
    this.material.dispose();
  }
}

// Hands the first numbers of an attribute to the graphics processor.
export function send(attribute, count) {
  if (count === 0) return;
  attribute.clearUpdateRanges();
  attribute.addUpdateRange(0, count);
  attribute.needsUpdate = true;
}
