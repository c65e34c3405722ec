// What is around the boxes: ground with a grid, light, shadows.
import {Color, DirectionalLight, HemisphereLight, Mesh, PlaneGeometry, ShadowMaterial, Vector3} from 'three';
import {theme} from './view_colours.js';

const SHADOW_PIXELS = 2048;
const FROM = new Vector3(-0.45, 1, 0.85).normalize();  // where the light comes from

// Lines a pixel wide, each fifth one stronger; where they get dense, and far away, they fade.
const GRID = `
uniform vec3 ground, grid, far, middle;
uniform float spacing, radius;
varying vec3 vWorld;
float lines(vec2 at) {
  vec2 pixel = fwidth(at);
  vec2 away = abs(fract(at - 0.5) - 0.5) / pixel;
  float line = 1.0 - min(min(away.x, away.y), 1.0);
  return line * (1.0 - smoothstep(0.1, 0.4, max(pixel.x, pixel.y)));
}
vec3 groundColour() {
  float away = smoothstep(1.5, 9.0, distance(vWorld.xz, middle.xz) / radius);
  float line = max(0.55 * lines(vWorld.xz / spacing), lines(vWorld.xz / (5.0 * spacing)));
  return mix(mix(ground, grid, line), far, away);
}`;

// The library's material is a shadow on nothing; here it gets a ground to lie on.
function drawGround(shader, uniforms) {
  Object.assign(shader.uniforms, uniforms);
  shader.vertexShader = shader.vertexShader
      .replace('void main() {', `varying vec3 vWorld;
        void main() {
          vWorld = (modelMatrix * vec4(position, 1.0)).xyz;`);
  shader.fragmentShader = shader.fragmentShader
      .replace('void main() {', `${GRID}\nvoid main() {`)
      .replace('gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );',
               'gl_FragColor = vec4(mix(groundColour(), color, opacity * (1.0 - getShadowMask())), 1.0);');
}

export class Ground {
  constructor(scene) {
    this.geometry = new PlaneGeometry(1, 1).rotateX(-Math.PI / 2);
    this.uniforms = {
      ground: {value: new Color()}, grid: {value: new Color()}, far: {value: new Color()},
      middle: {value: new Vector3()}, spacing: {value: 1}, radius: {value: 1},
    };
    // It lies at height 0, a little behind what stands on it.
    this.material = new ShadowMaterial({transparent: false, polygonOffset: true, polygonOffsetFactor: 1,
                                        polygonOffsetUnits: 2});
    this.material.onBeforeCompile = shader => drawGround(shader, this.uniforms);
    this.floor = new Mesh(this.geometry, this.material);
    this.floor.receiveShadow = true;

    this.sky = new HemisphereLight();
    this.sun = new DirectionalLight(0xffffff, 0.5 * Math.PI);
    this.sun.shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
    this.sun.shadow.radius = 2.5;
    this.sun.shadow.intensity = 0.6;
    this.sun.castShadow = true;
    scene.add(this.floor, this.sky, this.sun, this.sun.target);
  }

  setDark(dark) {
    const t = theme(dark);
    this.uniforms.ground.value.set(t.ground);
    this.uniforms.grid.value.set(t.grid);
    this.uniforms.far.value.set(t.background);
    this.material.opacity = t.shadow;
    this.sky.color.set('#ffffff');
    this.sky.groundColor.set(dark ? '#8b8f96' : '#b9b4aa');
    this.sky.intensity = 0.72 * Math.PI;
  }

  // Fits grid, light and shadow to a scene.
  fit(middle, radius, hasGround) {
    this.floor.visible = hasGround;
    const {uniforms, sun} = this;
    uniforms.middle.value.copy(middle);
    uniforms.radius.value = radius;
    uniforms.spacing.value = this.spacing = 10 ** Math.floor(Math.log10(0.6 * radius));
    this.floor.position.set(middle.x, 0, middle.z);
    this.floor.scale.setScalar(60 * radius);
    const reach = 2.2 * radius;
    sun.target.position.copy(middle);
    sun.position.copy(middle).addScaledVector(FROM, 2 * reach);
    const {camera} = sun.shadow;
    camera.left = camera.bottom = -reach;
    camera.right = camera.top = reach;
    camera.near = 0.1 * reach;
    camera.far = 4 * reach;
    camera.updateProjectionMatrix();
    sun.shadow.normalBias = 3 * reach / SHADOW_PIXELS;
    sun.shadow.bias = -1e-4;
  }

  get light() {  // where it comes from
    return this.sun.position;
  }

  get shadows() {
    return this.sun.castShadow;
  }

  set shadows(on) {
    this.sun.castShadow = on;
  }

  dispose() {
    this.sun.dispose();
    this.material.dispose();
    this.geometry.dispose();
  }
}
