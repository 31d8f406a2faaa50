(* Lattice (f) of THEORY.md: the bound on the circumradius at an encroached wall, where cells are sized before a mesh
   exists. (f) has two cases: (i) the two segments have no common point, (ii) they meet in a corner. *)
From Pardel Require Import Plane Pencil Lemma5 Growth.

(* The point of the segment mn at the fraction k. *)
Definition on_segment (m n : point) (k : R) : point := (m.x + k * (n.x - m.x), m.y + k * (n.y - m.y)).

(* (i), in numbers: a is half the length of the wall, h the distance of p from its line, and q the square of the distance
   of p from its perpendicular bisector. Then (|mp| |np|)^2 = (q + a^2 + h^2)^2 - 4 a^2 q. *)
Lemma product_largest_at_the_bisector : forall a h q, 0 <= q -> q <= a ^ 2 - h ^ 2 ->
  (q + a ^ 2 + h ^ 2) ^ 2 - 4 * a ^ 2 * q <= (a ^ 2 + h ^ 2) ^ 2.
Proof.
  intros a h q Q0 Q1.
  assert (0 <= q * (2 * a ^ 2 - 2 * h ^ 2 - q)).
  { apply Rmult_le_pos; [assumption|]; assert (0 <= a ^ 2 - h ^ 2) by lra; lra. }
  lra.
Qed.

(* (a^2 + h^2) / (2 h) falls in h for h < a and grows in a. *)
Lemma largest_at_the_ends : forall a h r0 lambda, 0 < lambda -> lambda <= h -> h < a -> a <= r0 ->
  (a ^ 2 + h ^ 2) / (2 * h) <= r0 * ((r0 / lambda + lambda / r0) / 2).
Proof.
  intros a h r0 lambda L H A R.
  replace (r0 * ((r0 / lambda + lambda / r0) / 2)) with ((r0 ^ 2 + lambda ^ 2) / (2 * lambda)) by (field; lra).
  apply Rmult_le_reg_r with (2 * h * lambda); [apply Rmult_lt_0_compat; lra|].
  replace ((a ^ 2 + h ^ 2) / (2 * h) * (2 * h * lambda)) with ((a ^ 2 + h ^ 2) * lambda) by (field; lra).
  replace ((r0 ^ 2 + lambda ^ 2) / (2 * lambda) * (2 * h * lambda)) with ((r0 ^ 2 + lambda ^ 2) * h) by (field; lra).
  assert (a ^ 2 <= r0 ^ 2) by (apply pow_incr; lra).
  assert (a ^ 2 * h <= r0 ^ 2 * h) by (apply Rmult_le_compat_r; lra).
  assert (0 <= (h - lambda) * (a ^ 2 - h * lambda)).
  { apply Rmult_le_pos; [lra|]; assert (h * lambda <= h * h) by (apply Rmult_le_compat_l; lra).
    assert (h * h <= a * a) by (apply Rmult_le_compat; lra). lra. }
  lra.
Qed.

(* Lattice (f), (i). The wall mn has at most the length 2 r0, p encroaches upon it, and no point of the wall is nearer to
   p than lambda. *)
Theorem Lattice_f_i : forall r0 lambda m n p o r,
  0 < lambda -> triangle m n p -> circumcircle m n p o r ->
  distance m n <= 2 * r0 -> in_diametral_circle m n p ->
  (forall k, 0 <= k <= 1 -> lambda <= distance p (on_segment m n k)) ->
  lambda < r0 /\ r <= r0 * ((r0 / lambda + lambda / r0) / 2).
Proof.
  intros r0 lambda m n p o r L T C M I Far.
  assert (D := edge_positive m n p T); assert (D2 := distance_squared m n).
  assert (H := height_on_the_left m n p T).
  rewrite in_diametral_circle_is_obtuse in I.
  set (d := distance m n) in *; set (h := height m n p) in *.
  (* the foot of p on the line is m + k (n - m) *)
  set (e := (n.x - m.x) * (p.x - m.x) + (n.y - m.y) * (p.y - m.y)).
  assert (Split : dot_at p m n = (e ^ 2 - d ^ 2 * e) / d ^ 2 + h ^ 2).
  { unfold h, height; fold d; unfold Rdiv; rewrite Rpow_mult_distr, pow_inv.
    apply Rmult_eq_reg_l with (d ^ 2); [|apply Rgt_not_eq, pow_lt; assumption].
    replace (d ^ 2 * ((e ^ 2 - d ^ 2 * e) * / d ^ 2 + twice_area m n p ^ 2 * / d ^ 2))
      with (e ^ 2 - d ^ 2 * e + twice_area m n p ^ 2) by (field; lra).
    rewrite D2; unfold e, square_distance, dot_at, twice_area; ring. }
  assert (Pd : 0 < d ^ 2) by now apply pow_lt.
  set (k := e / d ^ 2); assert (Ek : e = k * d ^ 2) by (unfold k; field; lra).
  assert (Split' : dot_at p m n = d ^ 2 * (k ^ 2 - k) + h ^ 2) by (rewrite Split, Ek; field; lra).
  assert (Hh : 0 < h ^ 2) by now apply pow_lt.
  assert (Hk : k ^ 2 - k < 0).
  { apply Rmult_lt_reg_l with (d ^ 2); [assumption|]; lra. }
  assert (K : 0 <= k <= 1) by (split; nra).
  assert (Foot : square_distance p (on_segment m n k) = h ^ 2).
  { apply Rmult_eq_reg_l with (d ^ 2); [|lra].
    replace (d ^ 2 * h ^ 2) with (twice_area m n p ^ 2) by (unfold h, height; fold d; field; lra).
    assert (E2 : e ^ 2 + twice_area m n p ^ 2 = square_distance m p * d ^ 2)
      by (rewrite D2; unfold e, twice_area, square_distance; ring).
    replace (square_distance p (on_segment m n k)) with (square_distance m p - 2 * k * e + k ^ 2 * d ^ 2)
      by (rewrite D2; unfold e, on_segment, square_distance; cbn [fst snd]; ring).
    replace (twice_area m n p ^ 2) with (square_distance m p * d ^ 2 - e ^ 2) by lra; rewrite Ek; ring. }
  assert (Lh : lambda <= h).
  { apply at_most_of_squares; [lra|]; rewrite <- Foot, <- distance_squared; apply pow_incr; split; [lra|].
    now apply Far. }
  set (a := d / 2); assert (Ea : d = 2 * a) by (unfold a; field).
  (* the square of the distance of p from the bisector is q *)
  set (q := (k - 1 / 2) ^ 2 * d ^ 2).
  assert (Q0 : 0 <= q) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]).
  assert (Q1 : q < a ^ 2 - h ^ 2).
  { rewrite Split' in I; unfold q, a; replace ((k - 1 / 2) ^ 2 * d ^ 2) with (d ^ 2 * (k ^ 2 - k) + (d / 2) ^ 2) by field.
    lra. }
  assert (A : h < a) by (apply below_of_squares; unfold a in *; lra).
  split; [unfold a in *; lra|].
  assert (B := product_largest_at_the_bisector a h q Q0 ltac:(lra)).
  apply Rle_trans with ((a ^ 2 + h ^ 2) / (2 * h)); [|apply largest_at_the_ends; unfold a in *; lra].
  assert (Nr := circle_radius_nonnegative m n o r (edge_of_circumcircle m n p o r C)).
  assert (F := circumradius_formula m n p o r C).
  assert (Prod : square_distance n p * square_distance p m = (q + a ^ 2 + h ^ 2) ^ 2 - 4 * a ^ 2 * q).
  { rewrite (square_distance_symmetric n p), Rmult_comm, lagrange, Split'.
    replace (twice_area m n p) with (h * d) by (unfold h, height; fold d; field; lra).
    unfold q, a; field. }
  assert (Area : twice_area m n p ^ 2 = h ^ 2 * d ^ 2) by (unfold h, height; fold d; field; lra).
  apply at_most_of_squares; [apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat; lra]|].
  { assert (0 <= a ^ 2) by apply pow2_ge_0; lra. }
  apply Rmult_le_reg_r with (4 * h ^ 2 * d ^ 2); [apply Rmult_lt_0_compat; lra|].
  replace (r ^ 2 * (4 * h ^ 2 * d ^ 2)) with (4 * r ^ 2 * twice_area m n p ^ 2) by (rewrite Area; ring).
  rewrite F, <- D2.
  replace (d ^ 2 * square_distance n p * square_distance p m)
    with (square_distance n p * square_distance p m * d ^ 2) by ring; rewrite Prod.
  replace (((a ^ 2 + h ^ 2) / (2 * h)) ^ 2 * (4 * h ^ 2 * d ^ 2)) with ((a ^ 2 + h ^ 2) ^ 2 * d ^ 2) by (field; lra).
  apply Rmult_le_compat_r; lra.
Qed.

(* (ii): p lies on a segment from the corner a, at an angle phi to the unit vector u along the other segment. The edge mn
   of the other segment has the ends a + k u and a + l u. *)
Definition along (a u : point) (k : R) : point := (a.x + k * u.x, a.y + k * u.y).
Definition unit_vector (u : point) : Prop := u.x ^ 2 + u.y ^ 2 = 1.
Definition at_angle (a u p : point) (phi : R) : Prop :=
  (p.x - a.x) * u.x + (p.y - a.y) * u.y = distance a p * cos phi.

(* p encroaches upon mn: it is inside or on the diametral circle, and no end of mn. *)
Definition encroaches (p m n : point) : Prop := dot_at p m n <= 0 /\ p <> m /\ p <> n.

Lemma diametral_circle_at_a_corner : forall a u p k l phi, unit_vector u -> at_angle a u p phi ->
  dot_at p (along a u k) (along a u l) = distance a p ^ 2 - (k + l) * (distance a p * cos phi) + k * l.
Proof.
  intros a u p k l phi U A; unfold at_angle, unit_vector in *; rewrite <- A, distance_squared.
  replace (k * l) with (k * l * (u.x ^ 2 + u.y ^ 2)) by (rewrite U; ring).
  unfold dot_at, along, square_distance; cbn [fst snd]; ring.
Qed.

(* No point of the other segment except a encroaches upon mn if the angle is 90 degrees or more. *)
Theorem Lattice_f_ii_wide_corner : forall a u p k l phi, unit_vector u -> at_angle a u p phi ->
  0 <= k -> k < l -> p <> a -> cos phi <= 0 -> ~ encroaches p (along a u k) (along a u l).
Proof.
  intros a u p k l phi U A K L P C (E & _).
  rewrite (diametral_circle_at_a_corner a u p k l phi U A) in E.
  assert (D : 0 < distance a p).
  { apply distance_positive; destruct (Rle_or_lt (square_distance a p) 0) as [N|]; [exfalso|assumption].
    unfold square_distance in N; assert (X := pow2_ge_0 (p.x - a.x)); assert (Y := pow2_ge_0 (p.y - a.y)).
    apply P; destruct a as [ax ay], p as [px py]; cbn [fst snd] in *.
    f_equal; apply Rminus_diag_uniq, zero_of_square; lra. }
  assert (0 < distance a p ^ 2) by now apply pow_lt.
  assert (0 <= k * l) by (apply Rmult_le_pos; lra).
  assert (0 <= (k + l) * (distance a p * - cos phi)) by (repeat apply Rmult_le_pos; lra).
  lra.
Qed.

(* If mn does not end in the corner, l <= 2 k since the segment was halved, and the angle is 60 degrees or more: no point
   encroaches. *)
Theorem Lattice_f_ii_edge_away_from_the_corner : forall a u p k l phi, unit_vector u -> at_angle a u p phi ->
  0 < k -> k < l -> l <= 2 * k -> cos phi <= 1 / 2 -> ~ encroaches p (along a u k) (along a u l).
Proof.
  intros a u p k l phi U A K L H C (E & _).
  rewrite (diametral_circle_at_a_corner a u p k l phi U A) in E.
  assert (D := distance_nonnegative a p); set (d := distance a p) in *.
  assert ((k + l) * (d * cos phi) <= (k + l) * (d * (1 / 2))).
  { apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra. }
  (* the discriminant of d^2 - (k + l) d / 2 + k l is negative *)
  assert (0 <= (d - (k + l) / 4) ^ 2) by apply pow2_ge_0.
  assert (0 < k * l - ((k + l) / 4) ^ 2).
  { assert (0 <= (2 * k - l) * (l - k)) by (apply Rmult_le_pos; lra).
    assert (0 < k * k) by (apply Rmult_lt_0_compat; lra).
    assert (0 < l * k) by (apply Rmult_lt_0_compat; lra). lra. }
  lra.
Qed.

(* If mn ends in the corner a: the circumradius is at most |an| / (2 sin phi), so at most r0 / sin phi. *)
Theorem Lattice_f_ii_edge_at_the_corner : forall a u p l phi r0 o r, unit_vector u -> at_angle a u p phi ->
  0 < phi < PI / 2 -> 0 < l <= 2 * r0 -> triangle a (along a u l) p -> circumcircle a (along a u l) p o r ->
  encroaches p a (along a u l) -> r <= r0 / sin phi.
Proof.
  intros a u p l phi r0 o r U A Phi L T C (E & _).
  assert (S : 0 < sin phi) by (apply sin_gt_0; lra).
  assert (One := sin2_cos2 phi); unfold Rsqr in One.
  assert (A0 : along a u 0 = a)
    by (unfold along; destruct a; cbn [fst snd]; f_equal; ring).
  rewrite <- A0 in E at 1; rewrite (diametral_circle_at_a_corner a u p 0 l phi U A) in E.
  assert (Nr := circle_radius_nonnegative _ _ o r (edge_of_circumcircle _ _ _ o r C)).
  assert (F := circumradius_formula _ _ _ o r C).
  assert (D := edge_positive a p (along a u l)).
  assert (Dp : 0 < distance a p).
  { apply distance_positive; rewrite square_distance_symmetric; apply (edge_of_triangle_positive p a (along a u l)).
    rewrite <- twice_area_turned, <- twice_area_turned, twice_area_turned.
    unfold triangle in T; rewrite twice_area_turned; rewrite <- twice_area_turned in T.
    rewrite <- twice_area_turned in T; lra. }
  clear D; set (d := distance a p) in *.
  assert (D2 : d ^ 2 = square_distance a p) by apply distance_squared.
  assert (Area : twice_area a (along a u l) p ^ 2 = l ^ 2 * (d ^ 2 * (sin phi * sin phi))).
  { assert (V : (u.x * (p.y - a.y) - u.y * (p.x - a.x)) ^ 2 = d ^ 2 - (d * cos phi) ^ 2).
    { unfold at_angle in A; fold d in A; rewrite <- A, D2.
      replace (square_distance a p) with (square_distance a p * (u.x ^ 2 + u.y ^ 2)) by (rewrite U; ring).
      unfold square_distance; ring. }
    replace (twice_area a (along a u l) p) with (l * (u.x * (p.y - a.y) - u.y * (p.x - a.x)))
      by (unfold twice_area, along; cbn [fst snd]; ring).
    rewrite Rpow_mult_distr, V; replace (sin phi * sin phi) with (1 - cos phi * cos phi) by lra; ring. }
  assert (Wall : square_distance a (along a u l) = l ^ 2).
  { replace (l ^ 2) with (l ^ 2 * (u.x ^ 2 + u.y ^ 2)) by (rewrite U; ring).
    unfold square_distance, along; cbn [fst snd]; ring. }
  assert (Third : square_distance (along a u l) p = d ^ 2 - 2 * l * (d * cos phi) + l ^ 2).
  { unfold at_angle in A; fold d in A; rewrite <- A, D2.
    replace (l ^ 2) with (l ^ 2 * (u.x ^ 2 + u.y ^ 2)) by (rewrite U; ring).
    unfold square_distance, along; cbn [fst snd]; ring. }
  rewrite Area, Wall, Third, (square_distance_symmetric p a), <- D2 in F.
  (* p is in the disk: |np| <= |an| *)
  assert (Near : d ^ 2 - 2 * l * (d * cos phi) + l ^ 2 <= l ^ 2).
  { assert (0 <= d ^ 2) by apply pow2_ge_0; lra. }
  assert (L2 : 0 < l ^ 2) by (apply pow_lt; lra); assert (P2 : 0 < d ^ 2) by now apply pow_lt.
  assert (G : 4 * r ^ 2 * (sin phi * sin phi) <= l ^ 2).
  { apply Rmult_le_reg_r with (l ^ 2 * d ^ 2); [now apply Rmult_lt_0_compat|].
    replace (4 * r ^ 2 * (sin phi * sin phi) * (l ^ 2 * d ^ 2))
      with (4 * r ^ 2 * (l ^ 2 * (d ^ 2 * (sin phi * sin phi)))) by ring.
    rewrite F; replace (l ^ 2 * (d ^ 2 - 2 * l * (d * cos phi) + l ^ 2) * d ^ 2)
      with ((d ^ 2 - 2 * l * (d * cos phi) + l ^ 2) * (l ^ 2 * d ^ 2)) by ring.
    apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|assumption]. }
  assert (W : 2 * r * sin phi <= l).
  { apply at_most_of_squares; [lra|]; replace ((2 * r * sin phi) ^ 2) with (4 * r ^ 2 * (sin phi * sin phi)) by ring.
    assumption. }
  apply Rmult_le_reg_r with (sin phi); [assumption|].
  replace (r0 / sin phi * sin phi) with r0 by (field; lra); lra.
Qed.
