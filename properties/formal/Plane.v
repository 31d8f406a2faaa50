(* Points, triangles and circles of the plane, over the real numbers: the words in which the other files state theorems
   of THEORY.md (section Conventions). *)
From Coq Require Export Reals Lra Psatz.
Open Scope R_scope.

Definition point : Type := (R * R)%type.
Notation "p .x" := (fst p) (at level 1, left associativity, format "p .x").
Notation "p .y" := (snd p) (at level 1, left associativity, format "p .y").

Definition square_distance (p q : point) : R := (q.x - p.x) ^ 2 + (q.y - p.y) ^ 2.
Definition distance (p q : point) : R := sqrt (square_distance p q).

(* Positive if a, b, c make a left turn, and zero if they lie on a line. *)
Definition twice_area (a b c : point) : R := (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x).
Definition area (a b c : point) : R := twice_area a b c / 2.

(* The scalar product of the vectors from p to a and from p to b. *)
Definition dot_at (p a b : point) : R := (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y).

(* Three points, counter-clockwise, that do not lie on a line. *)
Definition triangle (a b c : point) : Prop := 0 < twice_area a b c.
Definition shortest_edge (a b c : point) : R := Rmin (distance a b) (Rmin (distance b c) (distance c a)).

(* The circle with centre o and radius r. *)
Definition on_circle (o : point) (r : R) (p : point) : Prop := distance o p = r.
Definition in_disk (o : point) (r : R) (p : point) : Prop := distance o p < r.
Definition power (o : point) (r : R) (p : point) : R := square_distance o p - r ^ 2.
Definition circle_through (m n o : point) (r : R) : Prop := on_circle o r m /\ on_circle o r n.

(* o is the circumcentre of a, b, c and r is the circumradius. *)
Definition circumcircle (a b c o : point) (r : R) : Prop := on_circle o r a /\ on_circle o r b /\ on_circle o r c.

(* p lies strictly inside the circle with diameter mn. *)
Definition in_diametral_circle (m n p : point) : Prop :=
  in_disk ((m.x + n.x) / 2, (m.y + n.y) / 2) (distance m n / 2) p.

(* The signed distance of o from the line through m and n, positive on the left. *)
Definition height (m n o : point) : R := twice_area m n o / distance m n.

Lemma square_distance_nonnegative : forall p q, 0 <= square_distance p q.
Proof.
  intros p q; unfold square_distance.
  assert (0 <= (q.x - p.x) ^ 2) by apply pow2_ge_0.
  assert (0 <= (q.y - p.y) ^ 2) by apply pow2_ge_0.
  lra.
Qed.

Lemma distance_nonnegative : forall p q, 0 <= distance p q.
Proof. intros; apply sqrt_pos. Qed.

Lemma distance_squared : forall p q, distance p q ^ 2 = square_distance p q.
Proof. intros; unfold distance; apply pow2_sqrt, square_distance_nonnegative. Qed.

Lemma square_distance_symmetric : forall p q, square_distance p q = square_distance q p.
Proof. intros; unfold square_distance; ring. Qed.

Lemma distance_symmetric : forall p q, distance p q = distance q p.
Proof. intros; unfold distance; now rewrite square_distance_symmetric. Qed.

Lemma distance_triangle_inequality : forall p q r, distance p r <= distance p q + distance q r.
Proof.
  intros [px py] [qx qy] [rx ry].
  assert (H := Rgeom.triangle px py rx ry qx qy).
  unfold dist_euc, Rsqr in H; unfold distance, square_distance; cbn [fst snd].
  replace ((rx - px) ^ 2 + (ry - py) ^ 2) with ((px - rx) * (px - rx) + (py - ry) * (py - ry)) by ring.
  replace ((qx - px) ^ 2 + (qy - py) ^ 2) with ((px - qx) * (px - qx) + (py - qy) * (py - qy)) by ring.
  replace ((rx - qx) ^ 2 + (ry - qy) ^ 2) with ((qx - rx) * (qx - rx) + (qy - ry) * (qy - ry)) by ring.
  exact H.
Qed.

(* Comparing squares of numbers that are not negative. *)
Lemma below_of_squares : forall u v, 0 <= v -> u ^ 2 < v ^ 2 -> u < v.
Proof. intros; nra. Qed.
Lemma at_most_of_squares : forall u v, 0 <= v -> u ^ 2 <= v ^ 2 -> u <= v.
Proof. intros; nra. Qed.
Lemma equal_of_squares : forall u v, 0 <= u -> 0 <= v -> u ^ 2 = v ^ 2 -> u = v.
Proof. intros; nra. Qed.

Lemma zero_of_square : forall u, u ^ 2 = 0 -> u = 0.
Proof. intros; nra. Qed.

Lemma radius_nonnegative : forall o r p, on_circle o r p -> 0 <= r.
Proof. intros o r p <-; apply distance_nonnegative. Qed.

Lemma on_circle_squared : forall o r p, on_circle o r p -> square_distance o p = r ^ 2.
Proof. intros o r p <-; symmetry; apply distance_squared. Qed.

(* The power is negative inside the circle and zero on it. *)
Lemma in_disk_is_negative_power : forall o r p, 0 <= r -> (in_disk o r p <-> power o r p < 0).
Proof.
  intros o r p Hr; unfold in_disk, power; rewrite <- distance_squared.
  assert (H := distance_nonnegative o p); split; intro; nra.
Qed.

Lemma power_on_circle : forall o r p, on_circle o r p -> power o r p = 0.
Proof. intros o r p H; unfold power; rewrite (on_circle_squared _ _ _ H); ring. Qed.

(* A point lies strictly inside the diametral circle if it sees the edge at an obtuse angle. *)
Lemma in_diametral_circle_is_obtuse : forall m n p, in_diametral_circle m n p <-> dot_at p m n < 0.
Proof.
  intros m n p; unfold in_diametral_circle.
  assert (H := distance_nonnegative m n).
  rewrite in_disk_is_negative_power by lra.
  unfold power; replace ((distance m n / 2) ^ 2) with (square_distance m n / 4) by (rewrite <- distance_squared; field).
  unfold square_distance, dot_at; cbn [fst snd]; split; intro; nra.
Qed.

(* A triangle has edges of positive length. *)
Lemma twice_area_turned : forall a b c, twice_area b c a = twice_area a b c.
Proof. intros; unfold twice_area; ring. Qed.

Lemma edge_of_triangle_positive : forall a b c, twice_area a b c <> 0 -> 0 < square_distance a b.
Proof.
  intros a b c H; destruct (Rle_or_lt (square_distance a b) 0) as [H0|]; [exfalso|assumption].
  unfold square_distance in H0.
  assert (Hx := pow2_ge_0 (b.x - a.x)); assert (Hy := pow2_ge_0 (b.y - a.y)).
  assert (Ex : b.x - a.x = 0) by (apply zero_of_square; lra).
  assert (Ey : b.y - a.y = 0) by (apply zero_of_square; lra).
  apply H; unfold twice_area; rewrite Ex, Ey; ring.
Qed.

Lemma distance_positive : forall p q, 0 < square_distance p q -> 0 < distance p q.
Proof. intros; now apply sqrt_lt_R0. Qed.

(* |pm|^2 |pn|^2 is the square of the scalar product plus that of the vector product. *)
Lemma lagrange : forall m n p,
  square_distance p m * square_distance p n = dot_at p m n ^ 2 + twice_area m n p ^ 2.
Proof. intros; unfold square_distance, dot_at, twice_area; ring. Qed.

(* The circumradius is the product of the edges over four times the area. *)
Theorem circumradius_formula : forall a b c o r, circumcircle a b c o r ->
  4 * r ^ 2 * twice_area a b c ^ 2 = square_distance a b * square_distance b c * square_distance c a.
Proof.
  intros a b c o r (Ha & Hb & Hc).
  apply on_circle_squared in Ha, Hb, Hc.
  rewrite <- Ha; unfold square_distance, twice_area in *.
  set (px := b.x - a.x); set (py := b.y - a.y); set (qx := c.x - a.x); set (qy := c.y - a.y).
  set (wx := o.x - a.x); set (wy := o.y - a.y).
  assert (Hp : 2 * (px * wx + py * wy) = px ^ 2 + py ^ 2) by (unfold px, py, wx, wy; nra).
  assert (Hq : 2 * (qx * wx + qy * wy) = qx ^ 2 + qy ^ 2) by (unfold qx, qy, wx, wy; nra).
  set (k := px * qy - py * qx).
  assert (Hx : 2 * k * wx = (px ^ 2 + py ^ 2) * qy - (qx ^ 2 + qy ^ 2) * py)
    by (unfold k; rewrite <- Hp, <- Hq; ring).
  assert (Hy : 2 * k * wy = (qx ^ 2 + qy ^ 2) * px - (px ^ 2 + py ^ 2) * qx)
    by (unfold k; rewrite <- Hp, <- Hq; ring).
  replace (4 * ((a.x - o.x) ^ 2 + (a.y - o.y) ^ 2) * k ^ 2) with ((2 * k * wx) ^ 2 + (2 * k * wy) ^ 2)
    by (unfold wx, wy; ring).
  rewrite Hx, Hy; unfold px, py, qx, qy; ring.
Qed.

(* Every triangle has one circumcentre and one circumradius, so theorems about them speak of something. *)
Theorem circumcircle_exists : forall a b c, triangle a b c -> exists o r, circumcircle a b c o r.
Proof.
  intros a b c H; unfold triangle in H.
  set (k := twice_area a b c) in *.
  set (o := (a.x + (square_distance a b * (c.y - a.y) - square_distance a c * (b.y - a.y)) / (2 * k),
             a.y + (square_distance a c * (b.x - a.x) - square_distance a b * (c.x - a.x)) / (2 * k))).
  exists o, (distance o a); split; [reflexivity|].
  split; unfold on_circle, distance; f_equal; unfold o, square_distance, k, twice_area in *; cbn [fst snd]; field; lra.
Qed.

Theorem circumcircle_unique : forall a b c o r o' r', triangle a b c ->
  circumcircle a b c o r -> circumcircle a b c o' r' -> o = o' /\ r = r'.
Proof.
  intros a b c o r o' r' H (Ha & Hb & Hc) (Ha' & Hb' & Hc').
  assert (o = o') as ->.
  { clear - H Ha Hb Hc Ha' Hb' Hc'.
    apply on_circle_squared in Ha, Hb, Hc, Ha', Hb', Hc'.
    destruct o as [ox oy], o' as [ux uy]; unfold square_distance, triangle, twice_area in *; cbn [fst snd] in *.
    assert (E1 : (b.x - a.x) * (ox - ux) + (b.y - a.y) * (oy - uy) = 0) by nra.
    assert (E2 : (c.x - a.x) * (ox - ux) + (c.y - a.y) * (oy - uy) = 0) by nra.
    set (k := (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) in *.
    assert (F1 : k * (ox - ux) = 0).
    { replace (k * (ox - ux)) with ((c.y - a.y) * ((b.x - a.x) * (ox - ux) + (b.y - a.y) * (oy - uy))
        - (b.y - a.y) * ((c.x - a.x) * (ox - ux) + (c.y - a.y) * (oy - uy))) by (unfold k; ring).
      rewrite E1, E2; ring. }
    assert (F2 : k * (oy - uy) = 0).
    { replace (k * (oy - uy)) with ((b.x - a.x) * ((c.x - a.x) * (ox - ux) + (c.y - a.y) * (oy - uy))
        - (c.x - a.x) * ((b.x - a.x) * (ox - ux) + (b.y - a.y) * (oy - uy))) by (unfold k; ring).
      rewrite E1, E2; ring. }
    f_equal; nra. }
  split; [reflexivity|]. now rewrite <- Ha, <- Ha'.
Qed.
