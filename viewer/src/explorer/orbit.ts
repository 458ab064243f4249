import { Matrix4, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import type { NamedView } from '../model/report_data';

const radiansPerPixel = 0.008;
const radiansPerKey = 0.12;
const zoomPerWheelPixel = 0.0015;
const zoomPerKey = 1.15;
const zoomLimits = [0.4, 8] as const;
const turnMilliseconds = 350;

/**
 * The position of the camera around the model. Dragging, arrow keys and named views turn it; the wheel, pinching, + and
 * - zoom.
 */
export class Orbit {
  private readonly attitude = new Quaternion();
  private readonly offset = new Vector3();
  private zoom = 1;
  private readonly pointers = new Map<number, PointerEvent>();
  private current: NamedView;
  private turning = 0;

  constructor(
    private readonly element: HTMLElement,
    private readonly middle: Vector3,
    private readonly radius: number,
    home: NamedView,
    private readonly moved: () => void,
  ) {
    this.current = home;
    this.attitude.copy(attitudeOf(home));
    element.addEventListener('pointerdown', (e) => this.press(e));
    element.addEventListener('pointermove', (e) => this.drag(e));
    for (const name of ['pointerup', 'pointercancel'] as const)
      element.addEventListener(name, (e) => this.pointers.delete(e.pointerId));
    element.addEventListener('wheel', (e) => this.wheel(e), { passive: false });
    element.addEventListener('keydown', (e) => this.key(e));
  }

  get isDragging(): boolean {
    return this.pointers.size > 0;
  }

  /** Sets a camera to this position, so that the model fills a picture with this aspect ratio. */
  place(camera: PerspectiveCamera, aspect: number): void {
    camera.aspect = aspect;
    const half = Math.atan(Math.tan((camera.fov * Math.PI) / 360) * Math.min(1, aspect));
    const distance = this.radius / Math.sin(half);
    camera.zoom = this.zoom; // zooming does not move the camera into the model
    camera.near = distance / 20;
    camera.far = distance + 4 * this.radius;
    camera.quaternion.copy(this.attitude);
    camera.position.set(0, 0, distance).applyQuaternion(this.attitude).add(this.middle).add(this.offset);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  /** Turns to a named view and centres it. */
  lookFrom(view: NamedView): void {
    this.current = view;
    const start = this.attitude.clone(),
      end = attitudeOf(view);
    const offset = this.offset.clone(),
      zoom = this.zoom,
      begun = performance.now();
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    const turn = ++this.turning;
    const step = (now: number) => {
      if (turn !== this.turning) return;
      const share = still ? 1 : Math.min(1, Math.max(0, (now - begun) / turnMilliseconds));
      const eased = share * share * (3 - 2 * share);
      this.attitude.slerpQuaternions(start, end, eased);
      this.offset.copy(offset).multiplyScalar(1 - eased);
      this.zoom = zoom ** (1 - eased);
      this.moved();
      if (share < 1) requestAnimationFrame(step);
    };
    step(still ? begun : performance.now());
  }

  private press(e: PointerEvent): void {
    ++this.turning;
    this.element.setPointerCapture(e.pointerId);
    this.pointers.set(e.pointerId, e);
  }

  private drag(e: PointerEvent): void {
    const before = this.pointers.get(e.pointerId);
    if (!before) return;
    const dx = e.clientX - before.clientX,
      dy = e.clientY - before.clientY;
    if (this.pointers.size === 1) {
      if (e.shiftKey || e.buttons === 2) this.shift(dx, dy);
      else this.turn(-dx * radiansPerPixel, -dy * radiansPerPixel);
    } else {
      const others = [...this.pointers.values()].filter((p) => p.pointerId !== e.pointerId);
      const apart = (p: PointerEvent) => Math.hypot(p.clientX - others[0].clientX, p.clientY - others[0].clientY);
      this.zoomBy(apart(e) / Math.max(1, apart(before)));
      this.shift(dx / 2, dy / 2);
    }
    this.pointers.set(e.pointerId, e);
  }

  private wheel(e: WheelEvent): void {
    // Without focus, the wheel scrolls the page.
    if (document.activeElement !== this.element && !e.ctrlKey) return;
    e.preventDefault();
    this.zoomBy(Math.exp(-e.deltaY * zoomPerWheelPixel));
  }

  private key(e: KeyboardEvent): void {
    const act: Record<string, () => void> = {
      ArrowLeft: () => this.turn(radiansPerKey, 0),
      ArrowRight: () => this.turn(-radiansPerKey, 0),
      ArrowUp: () => this.turn(0, radiansPerKey),
      ArrowDown: () => this.turn(0, -radiansPerKey),
      '+': () => this.zoomBy(zoomPerKey),
      '=': () => this.zoomBy(zoomPerKey),
      '-': () => this.zoomBy(1 / zoomPerKey),
      '0': () => this.lookFrom(this.current),
    };
    if (e.ctrlKey || e.metaKey || e.altKey || !act[e.key]) return;
    e.preventDefault();
    act[e.key]();
  }

  private turn(aroundUp: number, aroundRight: number): void {
    this.attitude.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), aroundUp));
    this.attitude.multiply(new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), aroundRight)).normalize();
    this.moved();
  }

  private shift(dx: number, dy: number): void {
    const scale = (2.4 * this.radius) / this.zoom / Math.max(1, this.element.clientHeight);
    this.offset.add(new Vector3(-dx * scale, dy * scale, 0).applyQuaternion(this.attitude));
    this.moved();
  }

  private zoomBy(factor: number): void {
    this.zoom = Math.min(zoomLimits[1], Math.max(zoomLimits[0], this.zoom * factor));
    this.moved();
  }
}

function attitudeOf(view: NamedView): Quaternion {
  const eye = new Matrix4().lookAt(new Vector3(...view.from), new Vector3(), new Vector3(...view.up));
  return new Quaternion().setFromRotationMatrix(eye);
}
