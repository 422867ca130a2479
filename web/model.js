// SPDX-License-Identifier: MIT
// A glTF binary to turn round. It is drawn when something has changed, not all the time.
import { PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;

export class ModelView {
  // camera: {eye, target, fov}, in the model's coordinates, fov in degrees for a picture of 4 : 3.
  constructor(host, camera) {
    this.host = host;
    this.start = camera;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(camera.fov, 1, 0.001, 1000);
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    host.replaceChildren(this.renderer.domElement);
    this.renderer.domElement.setAttribute('aria-label', 'the baked scene, to be turned with the mouse');
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener('change', () => this.draw());
    new ResizeObserver(() => this.resize()).observe(host);
    this.home();
  }

  home() {
    const eye = new Vector3(...this.start.eye);
    const target = new Vector3(...this.start.target);
    const distance = eye.distanceTo(target);
    this.camera.near = distance / 1000;
    this.camera.far = distance * 100;
    this.camera.position.copy(eye);
    this.controls.target.copy(target);
    this.controls.update();
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0) {
      return;
    }
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    // What a picture of 4 : 3 shows stays in view in a narrower one.
    const half = Math.tan((this.start.fov * Math.PI) / 360) * Math.max(1, 4 / 3 / this.camera.aspect);
    this.camera.fov = (Math.atan(half) * 360) / Math.PI;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  async show(base64) {
    const wanted = (this.wanted = base64);
    const { scene } = await new GLTFLoader().parseAsync(bytesOf(base64), '');
    if (wanted === this.wanted) {
      this.scene.clear();
      this.scene.add(scene);
      this.draw();
    }
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }
}
