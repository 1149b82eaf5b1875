// SPDX-License-Identifier: MIT
import "../common/base.css";
import { el } from "../common/dom";

document.getElementById("monitor")?.append(el("h1", {}, "SensoTwin monitor"));
