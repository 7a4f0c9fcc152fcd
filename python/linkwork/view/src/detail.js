// Levels of detail. Where there are very many instances each is drawn as what one can see of it: its shape, the box
// around it, a line, or only the dot of its body; what is not in the picture is not drawn.

import { BoxGeometry, BufferAttribute, BufferGeometry, DynamicDrawUsage, Frustum, LineBasicMaterial, LineSegments, Matrix4, Vector3 } from "three";

const DOT = 1.5; // pixels: what is shorter is no more than the dot of its body
const LINE = 1; // what is thinner is a line
const BOX = 4; // what is thinner is a box

/** What part of the picture things take. */
export class Eye {
  /** `height` of the picture [pixels]. */
  constructor(camera, height) {
    camera.updateMatrixWorld();
    const m = camera.matrixWorld.elements;
    this.at = [m[12], m[13], m[14]];
    this.ahead = [-m[8], -m[9], -m[10]];
    this.near = camera.near;
    this.pixels = height / (2 * Math.tan((camera.fov * Math.PI) / 360));
    const frustum = new Frustum().setFromProjectionMatrix(new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    this.planes = Float64Array.from(frustum.planes.flatMap(({ normal, constant }) => [...normal.toArray(), constant]));
  }

  /** Pixels of a meter at a point; 0 where nothing within `reach` [m] of it is in the picture. */
  scale(x, y, z, reach) {
    const { planes, at, ahead } = this;
    for (let i = 0; i < 24; i += 4) {
      if (planes[i] * x + planes[i + 1] * y + planes[i + 2] * z + planes[i + 3] < -reach) return 0;
    }
    const depth = (x - at[0]) * ahead[0] + (y - at[1]) * ahead[1] + (z - at[2]) * ahead[2];
    return this.pixels / Math.max(depth - reach, this.near);
  }
}

/** Puts points into pixels of the picture, `out`; false behind the camera. */
export function projection(camera, width, height) {
  camera.updateMatrixWorld();
  const m = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  return (x, y, z, out) => {
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    out[0] = ((m[0] * x + m[4] * y + m[8] * z + m[12]) / w + 1) * 0.5 * width;
    out[1] = (1 - (m[1] * x + m[5] * y + m[9] * z + m[13]) / w) * 0.5 * height;
    return w > 0;
  };
}

/** Lines from end to end of what is too thin for more. */
export class Lines {
  constructor() {
    this.mesh = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true }));
    this.mesh.frustumCulled = false;
    this.#room(1024);
  }

  begin() {
    this.count = 0;
  }

  /** Along a column of an instance's matrix, in its color. */
  add(matrix, column, shades, k) {
    if (this.count === this.most) this.#room(2 * this.most);
    for (let end = 0; end < 2; end++) {
      const at = 6 * this.count + 3 * end;
      for (let c = 0; c < 3; c++) {
        this.positions[at + c] = matrix[12 + c] + (end - 0.5) * matrix[4 * column + c];
        this.colors[at + c] = shades[3 * k + c];
      }
    }
    this.count += 1;
  }

  end() {
    const { position, color } = this.mesh.geometry.attributes;
    for (const attribute of [position, color]) upload(attribute, 6 * this.count);
    this.mesh.geometry.setDrawRange(0, 2 * this.count);
    this.mesh.visible = this.count > 0;
  }

  #room(most) {
    const [positions, colors] = [this.positions, this.colors];
    Object.assign(this, { most, positions: new Float32Array(6 * most), colors: new Float32Array(6 * most) });
    if (positions) this.positions.set(positions);
    if (colors) this.colors.set(colors);
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.geometry.setAttribute("position", new BufferAttribute(this.positions, 3).setUsage(DynamicDrawUsage));
    this.mesh.geometry.setAttribute("color", new BufferAttribute(this.colors, 3).setUsage(DynamicDrawUsage));
  }
}

/** The instances of a part, chosen anew for each picture. */
export class Crowd {
  /** `instanced(geometry, material, count)` makes a mesh of instances. */
  constructor(part, instanced) {
    const { geometry, material, count } = part.mesh;
    geometry.computeBoundingBox();
    this.box = geometry.boundingBox;
    this.size = this.box.getSize(new Vector3()).toArray();
    const middle = this.box.getCenter(new Vector3());
    Object.assign(this, { part, count });
    part.measure(this.box);
    this.shades = new Float32Array(3 * count).fill(1);
    const boxes = instanced(new BoxGeometry(...this.size).translate(middle.x, middle.y, middle.z), material, count);
    this.levels = [part.mesh, boxes].map((mesh) => {
      mesh.setColorAt(0, { toArray: () => {} }); // makes room for colors
      return { mesh, index: new Int32Array(count) };
    });
    this.matrix = new Float32Array(16);
    this.middle = new Float64Array(3);
  }

  /** What is seen of each, into `seen`: how many as shapes, boxes, lines, smaller ones, and outside of the picture. */
  choose(eye, lines, seen) {
    const { part, matrix, middle: p } = this;
    const visible = part.mesh.visible;
    for (const { mesh } of this.levels) mesh.count = 0;
    for (let k = 0; visible && k < this.count; k++) {
      if (part.isHidden(k)) continue;
      const reach = part.around(k, p);
      const scale = eye.scale(p[0], p[1], p[2], reach);
      if (scale === 0) seen.outside += 1;
      else if (2 * reach * scale < DOT) seen.smaller += 1;
      else {
        part.put(k, matrix, 0);
        this.#draw(k, scale, lines, seen);
      }
    }
    this.levels[1].mesh.visible = visible;
    for (const { mesh } of this.levels) {
      upload(mesh.instanceMatrix, 16 * mesh.count);
      upload(mesh.instanceColor, 3 * mesh.count);
      mesh.boundingSphere = null;
    }
  }

  #draw(k, scale, lines, seen) {
    const { matrix, size } = this;
    const lengths = [0, 1, 2].map((axis) => size[axis] * Math.hypot(matrix[4 * axis], matrix[4 * axis + 1], matrix[4 * axis + 2]) * scale);
    const longest = lengths.indexOf(Math.max(...lengths));
    const second = Math.max(...lengths.filter((_, axis) => axis !== longest));
    if (lengths[longest] < DOT) seen.smaller += 1;
    else if (second < LINE) {
      lines.add(matrix, longest, this.shades, k);
      seen.lines += 1;
    } else {
      const { mesh, index } = this.levels[second < BOX ? 1 : 0];
      mesh.instanceMatrix.array.set(matrix, 16 * mesh.count);
      for (let c = 0; c < 3; c++) mesh.instanceColor.array[3 * mesh.count + c] = this.shades[3 * k + c];
      index[mesh.count] = k;
      mesh.count += 1;
      seen[second < BOX ? "boxes" : "shapes"] += 1;
    }
  }
}

/** Only so many numbers of an attribute have changed. */
function upload(attribute, count) {
  attribute.clearUpdateRanges();
  if (count > 0) attribute.addUpdateRange(0, count);
  attribute.needsUpdate = count > 0;
}
