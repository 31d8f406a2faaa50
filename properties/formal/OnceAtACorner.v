(* T2-once (ii) of THEORY.md: the bound on the circumradius of a new triangle at an encroached wall, if its segment and
   that of the new point meet in a corner. r0 is the bound on all circumradii. *)
From Pardel Require Import Plane Pencil Lemma5 Growth.

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
Theorem T2_once_ii_wide_corner : forall a u p k l phi, unit_vector u -> at_angle a u p phi ->
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

(* If mn does not end in the corner: l <= 3 k by the rule for split points. Then r <= r0 / (2 sin phi). *)
Theorem T2_once_ii_edge_away_from_the_corner : forall a u p k l phi r0 o r, unit_vector u -> at_angle a u p phi ->
  0 < phi < PI / 2 -> 0 < k -> k < l -> l <= 3 * k -> l - k <= 2 * r0 -> 0 < distance a p ->
  circumcircle (along a u k) (along a u l) p o r -> dot_at p (along a u k) (along a u l) < 0 ->
  r <= r0 / (2 * sin phi).
Proof.
  intros a u p k l phi r0 o r U A Phi K L T Len Dp C E.
  assert (S : 0 < sin phi) by (apply sin_gt_0; lra).
  assert (One := sin2_cos2 phi); unfold Rsqr in One.
  rewrite (diametral_circle_at_a_corner a u p k l phi U A) in E.
  assert (Nr := circle_radius_nonnegative _ _ o r (edge_of_circumcircle _ _ _ o r C)).
  assert (F := circumradius_formula _ _ _ o r C).
  set (d := distance a p) in *; assert (D2 : d ^ 2 = square_distance a p) by apply distance_squared.
  assert (C1 : cos phi <= 1) by apply COS_bound.
  set (c := cos phi) in *; set (s := sin phi) in *.
  assert (Edge : forall q, square_distance (along a u q) p = d ^ 2 - 2 * q * (d * c) + q ^ 2).
  { intro q; unfold at_angle in A; fold d c in A; rewrite <- A, D2.
    replace (q ^ 2) with (q ^ 2 * (u.x ^ 2 + u.y ^ 2)) by (rewrite U; ring).
    unfold square_distance, along; cbn [fst snd]; ring. }
  assert (Wall : square_distance (along a u k) (along a u l) = (l - k) ^ 2).
  { replace ((l - k) ^ 2) with ((l - k) ^ 2 * (u.x ^ 2 + u.y ^ 2)) by (rewrite U; ring).
    unfold square_distance, along; cbn [fst snd]; ring. }
  assert (Area : twice_area (along a u k) (along a u l) p ^ 2 = (l - k) ^ 2 * (d ^ 2 * s ^ 2)).
  { assert (V : (u.x * (p.y - a.y) - u.y * (p.x - a.x)) ^ 2 = d ^ 2 - (d * c) ^ 2).
    { unfold at_angle in A; fold d c in A; rewrite <- A, D2.
      replace (square_distance a p) with (square_distance a p * (u.x ^ 2 + u.y ^ 2)) by (rewrite U; ring).
      unfold square_distance; ring. }
    replace (twice_area (along a u k) (along a u l) p) with ((l - k) * (u.x * (p.y - a.y) - u.y * (p.x - a.x)))
      by (unfold twice_area, along; cbn [fst snd]; ring).
    rewrite Rpow_mult_distr, V; replace (s ^ 2) with (1 - c * c) by lra; ring. }
  rewrite Area, Wall, (square_distance_symmetric p), !Edge in F.
  (* x = d + k l / d, between 2 sqrt (k l) and (k + l) c *)
  set (x := d + k * l / d); assert (Ex : x * d = d ^ 2 + k * l) by (unfold x; field; lra).
  assert (Xc : x < (k + l) * c) by (apply Rmult_lt_reg_r with d; lra).
  assert (KL : 0 < k * l) by (apply Rmult_lt_0_compat; lra).
  assert (X0 : 0 < x) by (unfold x; assert (0 < k * l / d) by (now apply Rdiv_lt_0_compat); lra).
  assert (X2 : 4 * (k * l) <= x ^ 2).
  { apply Rmult_le_reg_r with (d ^ 2); [now apply pow_lt|].
    replace (x ^ 2 * d ^ 2) with ((d ^ 2 + k * l) ^ 2) by (rewrite <- Ex; ring).
    assert (0 <= (d ^ 2 - k * l) ^ 2) by apply pow2_ge_0; lra. }
  set (f := fun t : R => 4 * (k * l) * t ^ 2 - 2 * (k + l) * x * t + x ^ 2 + (l - k) ^ 2).
  assert (Prod : (d ^ 2 - 2 * k * (d * c) + k ^ 2) * (d ^ 2 - 2 * l * (d * c) + l ^ 2) = d ^ 2 * f c).
  { unfold f; replace (d ^ 2 * (4 * (k * l) * c ^ 2 - 2 * (k + l) * x * c + x ^ 2 + (l - k) ^ 2))
      with (d ^ 2 * (4 * (k * l) * c ^ 2) - 2 * (k + l) * (x * d) * d * c + (x * d) ^ 2 + d ^ 2 * (l - k) ^ 2) by ring.
    rewrite Ex; ring. }
  set (c0 := x / (k + l)); assert (Ec : c0 * (k + l) = x) by (unfold c0; field; lra).
  assert (C0 : c0 < c) by (apply Rmult_lt_reg_r with (k + l); lra).
  assert (H : 0 < (l - k) ^ 2) by (apply pow_lt; lra).
  (* f is convex, and at most (l - k)^2 / 4 at both ends *)
  assert (F0 : f c0 <= (l - k) ^ 2 / 4).
  { assert (X2' : 4 * (k * l) <= (c0 * (k + l)) ^ 2) by (rewrite Ec; exact X2).
    replace (f c0) with ((l - k) ^ 2 * (1 - c0 ^ 2)) by (unfold f; rewrite <- Ec; ring).
    assert (3 / 4 <= c0 ^ 2).
    { apply Rmult_le_reg_r with ((k + l) ^ 2); [apply pow_lt; lra|].
      assert (0 <= (3 * k - l) * (3 * l - k)) by (apply Rmult_le_pos; lra). lra. }
    replace ((l - k) ^ 2 / 4) with ((l - k) ^ 2 * (1 - 3 / 4)) by field; apply Rmult_le_compat_l; lra. }
  assert (F1 : f 1 <= (l - k) ^ 2 / 4).
  { replace (f 1) with ((k + l - x) ^ 2) by (unfold f; ring).
    replace ((l - k) ^ 2 / 4) with (((l - k) / 2) ^ 2) by field.
    assert (0 <= (l - k) * (9 * k - l)) by (apply Rmult_le_pos; lra).
    assert ((l + 3 * k) / 2 <= x) by (apply at_most_of_squares; lra).
    assert ((k + l) * c <= (k + l) * 1) by (apply Rmult_le_compat_l; lra).
    apply pow_incr; lra. }
  assert (Fc : f c <= (l - k) ^ 2 / 4).
  { apply Rmult_le_reg_r with (1 - c0); [lra|].
    assert (I : f c * (1 - c0) = f c0 * (1 - c) + f 1 * (c - c0) - 4 * (k * l) * ((c - c0) * (1 - c) * (1 - c0)))
      by (unfold f; ring).
    assert (0 <= (c - c0) * (1 - c) * (1 - c0)) by (repeat apply Rmult_le_pos; lra).
    assert (0 <= 4 * (k * l) * ((c - c0) * (1 - c) * (1 - c0))) by (apply Rmult_le_pos; lra).
    assert (f c0 * (1 - c) <= (l - k) ^ 2 / 4 * (1 - c)) by (apply Rmult_le_compat_r; lra).
    assert (f 1 * (c - c0) <= (l - k) ^ 2 / 4 * (c - c0)) by (apply Rmult_le_compat_r; lra).
    lra. }
  assert (G : (2 * r * s) ^ 2 <= r0 ^ 2).
  { assert ((l - k) ^ 2 <= (2 * r0) ^ 2) by (apply pow_incr; lra).
    assert (P2 : 0 < d ^ 2) by now apply pow_lt.
    assert ((2 * r * s) ^ 2 = f c); [|lra].
    apply Rmult_eq_reg_r with ((l - k) ^ 2 * d ^ 2); [|apply Rgt_not_eq, Rmult_lt_0_compat; assumption].
    replace ((2 * r * s) ^ 2 * ((l - k) ^ 2 * d ^ 2)) with (4 * r ^ 2 * ((l - k) ^ 2 * (d ^ 2 * s ^ 2))) by ring.
    rewrite F; replace (f c * ((l - k) ^ 2 * d ^ 2)) with ((l - k) ^ 2 * (d ^ 2 * f c)) by ring.
    rewrite <- Prod; ring. }
  assert (W : 2 * r * s <= r0) by (apply at_most_of_squares; lra).
  apply Rmult_le_reg_r with (2 * s); [lra|].
  replace (r0 / (2 * s) * (2 * s)) with r0 by (field; lra); lra.
Qed.

(* If mn ends in the corner a: the circumradius is at most |an| / (2 sin phi), so at most r0 / sin phi. *)
Theorem T2_once_ii_edge_at_the_corner : forall a u p l phi r0 o r, unit_vector u -> at_angle a u p phi ->
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
