(* Lemma 1 and Lemma 6 of THEORY.md, and the power functions of circles through two points. *)
From Pardel Require Import Plane.

(* Lemma 5, first sentence of the proof: the power with respect to a circle of the pencil. Here mn may lie anywhere. *)
Theorem power_in_the_pencil : forall m n o r x, circle_through m n o r -> 0 < distance m n ->
  power o r x = dot_at x m n - 2 * height m n o * height m n x.
Proof.
  intros m n o r x [Hm Hn] D.
  assert (M := on_circle_squared _ _ _ Hm); assert (N := on_circle_squared _ _ _ Hn).
  assert (D2 := distance_squared m n).
  unfold power; rewrite <- M.
  assert (E : square_distance m n * (square_distance o x - square_distance o m - dot_at x m n)
            = - 2 * (twice_area m n o * twice_area m n x)).
  { assert (H : 2 * ((n.x - m.x) * (o.x - m.x) + (n.y - m.y) * (o.y - m.y)) = square_distance m n)
      by (rewrite <- N in M; unfold square_distance in *; nra).
    replace (square_distance o x - square_distance o m - dot_at x m n)
      with (((n.x - m.x) * (x.x - m.x) + (n.y - m.y) * (x.y - m.y))
            - 2 * ((x.x - m.x) * (o.x - m.x) + (x.y - m.y) * (o.y - m.y)))
      by (unfold square_distance, dot_at; ring).
    rewrite Rmult_minus_distr_l; rewrite <- H at 1; unfold square_distance, twice_area; ring. }
  unfold height.
  apply Rmult_eq_reg_l with (distance m n ^ 2); [|apply Rgt_not_eq, pow_lt; assumption].
  rewrite <- D2 in E; field_simplify; [|lra]; lra.
Qed.

(* r^2 = h^2 + |mn|^2 / 4. *)
Theorem radius_in_the_pencil : forall m n o r, circle_through m n o r -> 0 < distance m n ->
  r ^ 2 = height m n o ^ 2 + distance m n ^ 2 / 4.
Proof.
  intros m n o r C D.
  assert (P := power_in_the_pencil m n o r o C D).
  unfold power in P.
  replace (square_distance o o) with 0 in P by (unfold square_distance; ring).
  destruct C as [Hm Hn].
  assert (M := on_circle_squared _ _ _ Hm); assert (N := on_circle_squared _ _ _ Hn).
  assert (D2 := distance_squared m n).
  assert (2 * dot_at o m n = 2 * r ^ 2 - distance m n ^ 2)
    by (rewrite D2; unfold dot_at, square_distance in *; lra).
  lra.
Qed.

Lemma edge_positive : forall m n p, triangle m n p -> 0 < distance m n.
Proof.
  intros m n p H; apply distance_positive, (edge_of_triangle_positive m n p); unfold triangle in H; lra.
Qed.

Lemma height_on_the_left : forall m n p, triangle m n p -> 0 < height m n p.
Proof. intros m n p H; apply Rdiv_lt_0_compat; [exact H|now apply (edge_positive m n p)]. Qed.

Lemma height_on_the_right : forall m n p, triangle n m p -> height m n p < 0.
Proof.
  intros m n p H; assert (D := edge_positive n m p H); rewrite distance_symmetric in D.
  unfold height; apply Rmult_lt_reg_r with (distance m n); [assumption|].
  replace (twice_area m n p / distance m n * distance m n) with (twice_area m n p) by (field; lra).
  unfold triangle, twice_area in *; lra.
Qed.

Lemma edge_of_circumcircle : forall m n l o r, circumcircle m n l o r -> circle_through m n o r.
Proof. intros m n l o r (M & N & _); split; assumption. Qed.

Lemma reversed_edge_of_circumcircle : forall m n l o r, circumcircle n m l o r -> circle_through m n o r.
Proof. intros m n l o r (N & M & _); split; assumption. Qed.

Lemma circle_radius_nonnegative : forall m n o r, circle_through m n o r -> 0 <= r.
Proof. intros m n o r [M _]; now apply (radius_nonnegative o r m). Qed.

(* Lemma 1 (monotone power). t = (m, n, l) and t' = (n, m, l') share the edge mn, which is locally Delaunay. *)
Theorem Lemma1_monotone_power : forall m n l l' o r o' r',
  triangle m n l -> triangle n m l' -> circumcircle m n l o r -> circumcircle n m l' o' r' ->
  ~ in_disk o r l' ->
  forall x, height m n x <= 0 -> power o' r' x <= power o r x.
Proof.
  intros m n l l' o r o' r' T T' C C' L x X.
  assert (D := edge_positive _ _ _ T).
  assert (E := edge_of_circumcircle _ _ _ _ _ C); assert (E' := reversed_edge_of_circumcircle _ _ _ _ _ C').
  assert (H := height_on_the_right _ _ _ T').
  assert (R := circle_radius_nonnegative _ _ _ _ E).
  assert (P : 0 <= power o r l') by (rewrite in_disk_is_negative_power in L; lra).
  assert (Z : power o' r' l' = 0) by (apply power_on_circle, C').
  rewrite (power_in_the_pencil m n o r l' E D) in P.
  rewrite (power_in_the_pencil m n o' r' l' E' D) in Z.
  rewrite (power_in_the_pencil m n o r x E D), (power_in_the_pencil m n o' r' x E' D).
  assert (height m n o' <= height m n o).
  { destruct (Rle_or_lt (height m n o') (height m n o)) as [|G]; [assumption|].
    assert (0 < (height m n o' - height m n o) * - height m n l') by (apply Rmult_lt_0_compat; lra).
    lra. }
  assert (0 <= (height m n o - height m n o') * - height m n x) by (apply Rmult_le_pos; lra).
  lra.
Qed.

(* "By symmetry, it is enough to test one of the two" (THEORY.md, Conventions). *)
Theorem local_delaunay_is_symmetric : forall m n l l' o r o' r',
  triangle m n l -> triangle n m l' -> circumcircle m n l o r -> circumcircle n m l' o' r' ->
  (in_disk o r l' <-> in_disk o' r' l).
Proof.
  assert (One : forall m n l l' o r o' r',
    triangle m n l -> triangle n m l' -> circumcircle m n l o r -> circumcircle n m l' o' r' ->
    in_disk o' r' l -> in_disk o r l').
  { intros m n l l' o r o' r' T T' C C' I.
    assert (D := edge_positive _ _ _ T).
    assert (E := edge_of_circumcircle _ _ _ _ _ C); assert (E' := reversed_edge_of_circumcircle _ _ _ _ _ C').
    destruct (Rlt_or_le (distance o l') r) as [|N]; [assumption|exfalso].
    assert (L := Lemma1_monotone_power m n l l' o r o' r' T T' C C' ltac:(unfold in_disk; lra)).
    assert (Hl := height_on_the_left _ _ _ T); assert (Hr := height_on_the_right _ _ _ T').
    assert (A := L l' ltac:(lra)).
    assert (Z : power o r l = 0) by (apply power_on_circle, C).
    assert (Z' : power o' r' l' = 0) by (apply power_on_circle, C').
    apply in_disk_is_negative_power in I; [|now apply (circle_radius_nonnegative m n o' r')].
    rewrite (power_in_the_pencil m n o r l' E D) in A; rewrite (power_in_the_pencil m n o' r' l' E' D) in A.
    rewrite (power_in_the_pencil m n o r l E D) in Z; rewrite (power_in_the_pencil m n o' r' l E' D) in I.
    assert (G : 0 < (height m n o' - height m n o) * height m n l) by lra.
    assert (0 < height m n o' - height m n o)
      by (apply Rmult_lt_reg_r with (height m n l); [assumption|rewrite Rmult_0_l; exact G]).
    assert (0 < (height m n o' - height m n o) * - height m n l') by (apply Rmult_lt_0_compat; lra).
    lra. }
  intros m n l l' o r o' r' T T' C C'; split; intro I.
  - exact (One n m l' l o' r' o r T' T C' C I).
  - exact (One m n l l' o r o' r' T T' C C' I).
Qed.

(* The test of is_outside_circle() in the checker: d lies outside the circumcircle of (m, n, c) if the sum of the angles
   at c and d over mn is below 180 degrees. *)
Theorem sign_of_the_circle_test : forall m n c o r d, triangle m n c -> circumcircle m n c o r ->
  (r < distance o d <-> 0 < twice_area m n c * dot_at d m n + dot_at c m n * - twice_area m n d).
Proof.
  intros m n c o r d T C; assert (D := edge_positive _ _ _ T).
  assert (E := edge_of_circumcircle _ _ _ _ _ C); assert (R := circle_radius_nonnegative _ _ _ _ E).
  assert (Z : power o r c = 0) by (apply power_on_circle, C).
  assert (Pd := power_in_the_pencil m n o r d E D); rewrite (power_in_the_pencil m n o r c E D) in Z.
  assert (K : twice_area m n c * dot_at d m n + dot_at c m n * - twice_area m n d = twice_area m n c * power o r d).
  { rewrite Pd; replace (dot_at c m n) with (2 * height m n o * height m n c) by lra; unfold height; field; lra. }
  rewrite K; unfold triangle in T; unfold power; rewrite <- distance_squared.
  assert (N := distance_nonnegative o d); split; intro H.
  - apply Rmult_lt_0_compat; [assumption|nra].
  - assert (0 < distance o d ^ 2 - r ^ 2) by (apply Rmult_lt_reg_l with (twice_area m n c); lra). nra.
Qed.

(* Lemma 6 (reach), for one triangle: v lies on a circle, and p lies inside it. *)
Theorem Lemma6_reach : forall o r v p, on_circle o r v -> in_disk o r p -> distance p v < 2 * r.
Proof.
  intros o r v p V P; unfold on_circle, in_disk in *.
  assert (H := distance_triangle_inequality p o v); rewrite (distance_symmetric p o) in H; lra.
Qed.

(* Two points in one disk. *)
Theorem two_points_in_one_disk : forall o r p q, in_disk o r p -> in_disk o r q -> distance p q < 2 * r.
Proof.
  intros o r p q P Q; unfold in_disk in *.
  assert (H := distance_triangle_inequality p o q); rewrite (distance_symmetric p o) in H; lra.
Qed.
