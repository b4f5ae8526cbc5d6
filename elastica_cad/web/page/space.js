// The bent strip, or a whole model, in space; turned by mouse, touch and keyboard.
import * as THREE from "./vendor/three.module.min.js";
import { COLORS, stepOf } from "./colors.js";

const UPRIGHT = [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1]; // the drawing's y is up, column by column
const TURN = 0.01; // rad for a pixel

export class Space {
  constructor(host, t) {
    this.host = host;
    this.turn = { around: -0.9, up: 0.35, zoom: 1 };
    try {
      this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
    } catch {
      host.textContent = t("This browser cannot show 3D. Use a browser with WebGL.");
      return;
    }
    const canvas = this.renderer.domElement, gl = this.renderer.getContext(), told = gl.getExtension("WEBGL_debug_renderer_info");
    this.isSlow = /swiftshader|llvmpipe|software/i.test(told ? gl.getParameter(told.UNMASKED_RENDERER_WEBGL) : "");
    Object.assign(canvas, { tabIndex: 0 });
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", t("Bent strip in space. Arrow keys turn the view."));
    host.append(canvas);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(35, 1, 1, 1e5);
    this.camera.up.set(0, 0, 1);
    this.sun = new THREE.DirectionalLight(0xffffff, 2.2);
    this.scene.add(this.sun, new THREE.HemisphereLight(0xffffff, 0x666666, 1.6));
    this.skin = new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide });
    this.board = new THREE.MeshLambertMaterial({ color: 0xb9a07a, side: THREE.DoubleSide });
    this.colors = COLORS.map((color) => new THREE.Color(color));
    this.fingers = new Map();
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    canvas.addEventListener("pointermove", (event) => this.moved(event));
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (event) => this.fingers.delete(event.pointerId));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.turned(0, 0, Math.exp(event.deltaY / 400));
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => this.typed(event));
    new ResizeObserver(() => this.drawSoon()).observe(host);
  }

  moved(event) {
    const before = this.fingers.get(event.pointerId), now = [event.clientX, event.clientY];
    if (!before) return;
    const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
    this.fingers.set(event.pointerId, now);
    if (other) {
      const apart = (p) => Math.max(Math.hypot(p[0] - other[0], p[1] - other[1]), 1);
      this.turned(0, 0, apart(before) / apart(now));
    } else this.turned(-TURN * (now[0] - before[0]), TURN * (now[1] - before[1]), 1);
  }

  typed(event) {
    const ways = {
      ArrowLeft: [0.15, 0, 1], ArrowRight: [-0.15, 0, 1], ArrowUp: [0, 0.15, 1], ArrowDown: [0, -0.15, 1],
      "+": [0, 0, 0.8], "-": [0, 0, 1.25],
    };
    if (!ways[event.key]) return;
    event.preventDefault();
    this.turned(...ways[event.key]);
  }

  turned(around, up, zoom) {
    this.turn.around += around;
    this.turn.up = Math.min(Math.max(this.turn.up + up, -1.5), 1.5);
    this.turn.zoom = Math.min(Math.max(this.turn.zoom * zoom, 0.1), 10);
    this.drawSoon();
  }

  // Strips in the plane of their drawing.
  showAll(shapes) {
    this.showModel({ shapes, places: shapes.map((_, k) => [k, UPRIGHT]), plates: [] });
  }

  showModel({ shapes, places, plates }) {
    if (!this.renderer) return;
    const made = shapes.map((shape) => this.ribbon(shape));
    const parts = places.map(([k, matrix]) => placed(new THREE.Mesh(made[k], this.skin), matrix));
    for (const plate of plates) parts.push(placed(new THREE.Mesh(board(plate), this.board), plate.frame));
    this.group?.traverse((part) => part.geometry?.dispose());
    if (this.group) this.scene.remove(this.group);
    this.group = new THREE.Group();
    for (const part of parts) this.group.add(part);
    this.scene.add(this.group);
    if (parts.length) this.ball = new THREE.Box3().setFromObject(this.group).getBoundingSphere(new THREE.Sphere());
    this.drawSoon();
  }

  // Rulings as long as the strip is wide, across the plane of its curve.
  ribbon({ position, width, shares }) {
    const places = [], shades = [], corners = [];
    position.forEach(([x, y], k) => {
      const { r, g, b } = this.colors[stepOf(shares[Math.min(Math.max(k - 1, 0), shares.length - 1)])];
      for (const side of [-0.5, 0.5]) {
        places.push(x, y, side * width[k]);
        shades.push(r, g, b);
      }
      if (k) corners.push(2 * k - 2, 2 * k - 1, 2 * k, 2 * k, 2 * k - 1, 2 * k + 1);
    });
    const made = new THREE.BufferGeometry();
    made.setAttribute("position", new THREE.Float32BufferAttribute(places, 3));
    made.setAttribute("color", new THREE.Float32BufferAttribute(shades, 3));
    made.setIndex(corners);
    made.computeVertexNormals();
    return made;
  }

  drawSoon() {
    if (!this.renderer || this.due) return;
    this.due = requestAnimationFrame(() => {
      this.due = null;
      this.draw();
    });
  }

  draw() {
    const [width, height] = [this.host.clientWidth, this.host.clientHeight];
    if (!this.ball || !width || !height) return;
    if (this.seen !== `${width} ${height}`) this.renderer.setSize(width, height);
    this.seen = `${width} ${height}`;
    const { around, up, zoom } = this.turn, far = 1.05 * zoom * this.ball.radius / Math.sin((17.5 * Math.PI) / 180) / Math.min(width / height, 1);
    const way = new THREE.Vector3(Math.cos(up) * Math.cos(around), Math.cos(up) * Math.sin(around), Math.sin(up));
    Object.assign(this.camera, { aspect: width / height, near: far / 100, far: 10 * far });
    this.camera.updateProjectionMatrix();
    this.camera.position.copy(this.ball.center).addScaledVector(way, far);
    this.camera.lookAt(this.ball.center);
    this.sun.position.copy(way).applyAxisAngle(this.camera.up, 0.5);
    this.renderer.render(this.scene, this.camera);
  }
}

function placed(part, matrix) {
  part.applyMatrix4(new THREE.Matrix4().fromArray(matrix));
  return part;
}

function board({ loops, thickness }) {
  const [outline, ...holes] = loops.map((loop) => loop.map(([x, y]) => new THREE.Vector2(x, y)));
  const shape = new THREE.Shape(outline);
  shape.holes = holes.map((hole) => new THREE.Path(hole));
  return new THREE.ExtrudeGeometry(shape, { depth: thickness, bevelEnabled: false });
}
