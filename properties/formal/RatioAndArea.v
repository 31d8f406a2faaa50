(* T3 and T3-sharp of THEORY.md: bounds on ratio and area bound the circumradius. *)
From Pardel Require Import Plane.

(* The circumradius over the shortest edge. *)
Definition ratio (a b c : point) (r : R) : R := r / shortest_edge a b c.

(* r* of T3-sharp. *)
Definition sharp_bound (rho delta : R) : R := 2 * rho ^ 2 * sqrt delta / Rpower (4 * rho ^ 2 - 1) (1 / 4).

Definition two_edges_are_shortest (a b c : point) : Prop :=
  let e := shortest_edge a b c in
  (distance a b = e /\ distance b c = e) \/ (distance b c = e /\ distance c a = e) \/
  (distance c a = e /\ distance a b = e).

(* Fourth roots and powers of 3/2. *)
Lemma fourth_root : forall v, 0 < v -> 0 < Rpower v (1 / 4) /\ Rpower v (1 / 4) ^ 4 = v.
Proof.
  intros v Hv; split; [unfold Rpower; apply exp_pos|].
  rewrite <- Rpower_pow by (unfold Rpower; apply exp_pos).
  rewrite Rpower_mult; replace (1 / 4 * INR 4) with 1 by (simpl; field).
  now apply Rpower_1.
Qed.

Lemma power_three_halves : forall v, 0 < v -> 0 < Rpower v (3 / 2) /\ Rpower v (3 / 2) ^ 2 = v ^ 3.
Proof.
  intros v Hv; split; [unfold Rpower; apply exp_pos|].
  rewrite <- Rpower_pow by (unfold Rpower; apply exp_pos).
  rewrite Rpower_mult; replace (3 / 2 * INR 2) with (INR 3) by (simpl; field).
  now apply Rpower_pow.
Qed.

Lemma at_most_of_fourth_powers : forall u v, 0 <= v -> u ^ 4 <= v ^ 4 -> u <= v.
Proof.
  intros u v Hv H; apply at_most_of_squares; [assumption|]; apply at_most_of_squares; [apply pow2_ge_0|].
  replace ((u ^ 2) ^ 2) with (u ^ 4) by ring; replace ((v ^ 2) ^ 2) with (v ^ 4) by ring; exact H.
Qed.

(* The heart of the proof. S, T, U are the squares of the edges, S is the least, K is the square of twice the area, and q
   is the square of the circumradius. *)
Section Squares.
  Variables S T U K q : R.
  Hypothesis S_positive : 0 < S.
  Hypothesis S_least : S <= T /\ S <= U.
  Hypothesis heron : 4 * K = 2 * S * T + 2 * T * U + 2 * U * S - S ^ 2 - T ^ 2 - U ^ 2.
  Hypothesis K_positive : 0 < K.
  Hypothesis circumradius : 4 * q * K = S * T * U.

  Lemma excess : 4 * K * (T * U * q - S ^ 2 * (4 * q - S)) = S * ((T - S) * (U - S)) * (T * U + S * (T + U - S)).
  Proof.
    replace (4 * K * (T * U * q - S ^ 2 * (4 * q - S)))
      with (4 * q * K * (T * U - 4 * S ^ 2) + S ^ 3 * (4 * K)) by ring.
    rewrite circumradius, heron; ring.
  Qed.

  Lemma factor_positive : 0 < T * U + S * (T + U - S).
  Proof. destruct S_least; assert (0 < T * U) by (apply Rmult_lt_0_compat; lra). nra. Qed.

  Lemma q_positive : 0 < q.
  Proof.
    destruct S_least; assert (0 < S * T * U) by (repeat apply Rmult_lt_0_compat; lra).
    destruct (Rle_or_lt q 0); [nra|assumption].
  Qed.

  Lemma area_at_least : S ^ 2 * (4 * q - S) <= T * U * q.
  Proof.
    destruct S_least; assert (E := excess); assert (F := factor_positive).
    assert (0 <= S * ((T - S) * (U - S)) * (T * U + S * (T + U - S)))
      by (repeat apply Rmult_le_pos; lra).
    nra.
  Qed.

  Lemma area_least_if_isosceles : S ^ 2 * (4 * q - S) = T * U * q <-> T = S \/ U = S.
  Proof.
    assert (E := excess); assert (F := factor_positive); split.
    - intro H; replace (T * U * q - S ^ 2 * (4 * q - S)) with 0 in E by lra.
      rewrite Rmult_0_r in E; symmetry in E.
      apply Rmult_integral in E; destruct E as [E|]; [|lra].
      apply Rmult_integral in E; destruct E as [|E]; [lra|].
      apply Rmult_integral in E; destruct E; [left|right]; lra.
    - intros [H|H]; rewrite H in E; replace (S - S) with 0 in E by ring;
        rewrite ?Rmult_0_l, ?Rmult_0_r, ?Rmult_0_l in E; apply Rmult_integral in E; rewrite H; lra.
  Qed.

  Lemma ratio_at_least : S <= 3 * q.
  Proof.
    destruct S_least.
    assert (0 <= (T + U - 2 * S) * (3 * (T + U) - 2 * S) / 4 + (T - U) ^ 2 / 4).
    { assert (0 <= (T - U) ^ 2) by apply pow2_ge_0.
      assert (0 <= (T + U - 2 * S) * (3 * (T + U) - 2 * S)) by (apply Rmult_le_pos; lra). lra. }
    assert (S * (4 * K) <= 3 * (S * T * U)).
    { rewrite heron.
      replace (3 * (S * T * U)) with (S * (3 * T * U)) by ring; apply Rmult_le_compat_l; [lra|nra]. }
    nra.
  Qed.
End Squares.

(* s^4 / (4 s - 1) grows from s = 1/3 on. *)
Lemma quartic_grows : forall s t, 1 / 3 <= s -> s < t -> (4 * t - 1) * s ^ 4 < (4 * s - 1) * t ^ 4.
Proof.
  intros s t Hs Hst.
  assert (E : (4 * s - 1) * t ^ 4 - (4 * t - 1) * s ^ 4
    = (t - s) * ((4 * s - 1) * (t ^ 3 + t ^ 2 * s + t * s ^ 2 + s ^ 3) - 4 * s ^ 4)) by ring.
  assert (0 < (4 * s - 1) * (t ^ 3 + t ^ 2 * s + t * s ^ 2 + s ^ 3) - 4 * s ^ 4).
  { assert (0 < s ^ 3) by (apply pow_lt; lra).
    assert (0 < s ^ 2) by (apply pow_lt; lra).
    assert (s ^ 2 < t ^ 2) by nra.
    assert (s ^ 2 * s < t ^ 2 * s) by (apply Rmult_lt_compat_r; lra).
    assert (s ^ 2 * s < s ^ 2 * t) by (apply Rmult_lt_compat_l; lra).
    assert (t ^ 2 * s < t ^ 2 * t) by (apply Rmult_lt_compat_l; lra).
    replace (s ^ 3) with (s ^ 2 * s) in * by ring; replace (t ^ 3) with (t ^ 2 * t) by ring.
    assert ((4 * s - 1) * (4 * (s ^ 2 * s)) < (4 * s - 1) * (t ^ 2 * t + t ^ 2 * s + t * s ^ 2 + s ^ 2 * s))
      by (apply Rmult_lt_compat_l; lra).
    assert (0 <= (3 * s - 1) * (s ^ 2 * s)) by (apply Rmult_le_pos; lra).
    lra. }
  nra.
Qed.

Lemma quartic_grows_weakly : forall s t, 1 / 3 <= s -> s <= t -> (4 * t - 1) * s ^ 4 <= (4 * s - 1) * t ^ 4.
Proof. intros s t Hs [H| ->]; [left; now apply quartic_grows|right; ring]. Qed.

Section Bound.
  Variables S T U k r rho delta : R.
  Hypothesis S_positive : 0 < S.
  Hypothesis S_least : S <= T /\ S <= U.
  Hypothesis heron : 4 * k ^ 2 = 2 * S * T + 2 * T * U + 2 * U * S - S ^ 2 - T ^ 2 - U ^ 2.
  Hypothesis k_positive : 0 < k.
  Hypothesis circumradius : 4 * r ^ 2 * k ^ 2 = S * T * U.
  Hypothesis r_nonnegative : 0 <= r.
  Hypothesis rho_nonnegative : 0 <= rho.
  Hypothesis rho_bounds : r ^ 2 <= rho ^ 2 * S.
  Hypothesis delta_bounds : k / 2 <= delta.

  Let s : R := r ^ 2 / S.

  Lemma s_defined : s * S = r ^ 2.
  Proof. unfold s; field; lra. Qed.

  Lemma k_squared_positive : 0 < k ^ 2.
  Proof. apply pow_lt; lra. Qed.

  Lemma s_at_least : 1 / 3 <= s.
  Proof.
    assert (S <= 3 * r ^ 2) by (apply (ratio_at_least S T U (k ^ 2)); auto using k_squared_positive).
    assert (E := s_defined); destruct (Rle_or_lt (1 / 3) s); [assumption|nra].
  Qed.

  Lemma s_at_most : s <= rho ^ 2.
  Proof. assert (E := s_defined); destruct (Rle_or_lt s (rho ^ 2)); [assumption|nra]. Qed.

  Lemma r_positive : 0 < r ^ 2.
  Proof. apply (q_positive S T U (k ^ 2)); auto using k_squared_positive. Qed.

  (* The two sides of area_at_least, in s. *)
  Lemma in_s : T * U * r ^ 2 - S ^ 2 * (4 * r ^ 2 - S) = (4 * k ^ 2 * s ^ 4 - r ^ 4 * (4 * s - 1)) * (S ^ 3 / r ^ 4).
  Proof.
    assert (Q := r_positive).
    assert (0 < r) by (destruct r_nonnegative as [|<-]; [assumption|simpl in Q; lra]).
    replace (T * U) with (4 * r ^ 2 * k ^ 2 / S) by (rewrite circumradius; field; lra).
    unfold s; field; lra.
  Qed.

  Lemma weight_positive : 0 < S ^ 3 / r ^ 4.
  Proof.
    assert (Q := r_positive); apply Rdiv_lt_0_compat; [now apply pow_lt|].
    replace (r ^ 4) with (r ^ 2 * r ^ 2) by ring; nra.
  Qed.

  Lemma in_own_ratio : r ^ 4 * (4 * s - 1) <= 4 * k ^ 2 * s ^ 4.
  Proof.
    assert (H : S ^ 2 * (4 * r ^ 2 - S) <= T * U * r ^ 2)
      by (apply (area_at_least S T U (k ^ 2)); auto using k_squared_positive).
    assert (E := in_s); assert (W := weight_positive).
    destruct (Rle_or_lt (r ^ 4 * (4 * s - 1)) (4 * k ^ 2 * s ^ 4)); [assumption|nra].
  Qed.

  Lemma in_own_ratio_equal : r ^ 4 * (4 * s - 1) = 4 * k ^ 2 * s ^ 4 <-> T = S \/ U = S.
  Proof.
    rewrite <- (area_least_if_isosceles S T U (k ^ 2) (r ^ 2)) by auto using k_squared_positive.
    assert (E := in_s); assert (W := weight_positive); split; intro H.
    - rewrite H in E; lra.
    - replace (T * U * r ^ 2 - S ^ 2 * (4 * r ^ 2 - S)) with 0 in E by lra.
      symmetry in E; apply Rmult_integral in E; lra.
  Qed.

  Lemma rho_at_least : 1 / 3 <= rho ^ 2.
  Proof. assert (A := s_at_least); assert (B := s_at_most); lra. Qed.

  Lemma s4_positive : 0 < s ^ 4.
  Proof. assert (A := s_at_least); apply pow_lt; lra. Qed.

  Lemma areas : k ^ 2 <= 4 * delta ^ 2.
  Proof. nra. Qed.

  (* In one step each: the least area of the own ratio, the bound on the area, the bound on the ratio. *)
  Lemma quartic_bound : r ^ 4 * (4 * rho ^ 2 - 1) <= 16 * (rho ^ 2) ^ 4 * delta ^ 2.
  Proof.
    assert (A := s_at_least); assert (B := s_at_most); assert (C := in_own_ratio); assert (D := areas).
    assert (P := s4_positive); assert (G := quartic_grows_weakly s (rho ^ 2) A B).
    assert (0 <= (rho ^ 2) ^ 4) by (apply pow_le; lra).
    assert (r ^ 4 * (4 * s - 1) <= 16 * delta ^ 2 * s ^ 4).
    { apply Rle_trans with (1 := C); replace (16 * delta ^ 2 * s ^ 4) with (4 * (4 * delta ^ 2) * s ^ 4) by ring.
      apply Rmult_le_compat_r; lra. }
    apply Rmult_le_reg_r with (s ^ 4 * (4 * s - 1)); [apply Rmult_lt_0_compat; lra|].
    apply Rle_trans with (16 * delta ^ 2 * s ^ 4 * ((4 * rho ^ 2 - 1) * s ^ 4)).
    - replace (r ^ 4 * (4 * rho ^ 2 - 1) * (s ^ 4 * (4 * s - 1)))
        with (r ^ 4 * (4 * s - 1) * ((4 * rho ^ 2 - 1) * s ^ 4)) by ring.
      apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|assumption].
    - replace (16 * (rho ^ 2) ^ 4 * delta ^ 2 * (s ^ 4 * (4 * s - 1)))
        with (16 * delta ^ 2 * s ^ 4 * ((4 * s - 1) * (rho ^ 2) ^ 4)) by ring.
      apply Rmult_le_compat_l; [|assumption].
      apply Rmult_le_pos; [assert (0 <= delta ^ 2) by apply pow2_ge_0; lra|lra].
  Qed.

  Lemma quartic_bound_equal :
    r ^ 4 * (4 * rho ^ 2 - 1) = 16 * (rho ^ 2) ^ 4 * delta ^ 2 <->
    k / 2 = delta /\ r ^ 2 = rho ^ 2 * S /\ (T = S \/ U = S).
  Proof.
    assert (A := s_at_least); assert (B := s_at_most); assert (C := in_own_ratio); assert (D := areas).
    assert (P := s4_positive); assert (E := s_defined); split.
    - intro H.
      assert (R4 : 0 <= r ^ 4) by (apply pow_le; lra).
      assert (Q4 : 0 < (rho ^ 2) ^ 4) by (apply pow_lt; lra).
      assert (Own : 16 * delta ^ 2 * s ^ 4 <= r ^ 4 * (4 * s - 1)).
      { apply Rmult_le_reg_r with ((rho ^ 2) ^ 4 ); [assumption|].
        replace (16 * delta ^ 2 * s ^ 4 * (rho ^ 2) ^ 4) with (16 * (rho ^ 2) ^ 4 * delta ^ 2 * s ^ 4) by ring.
        rewrite <- H.
        replace (r ^ 4 * (4 * rho ^ 2 - 1) * s ^ 4) with (r ^ 4 * ((4 * rho ^ 2 - 1) * s ^ 4)) by ring.
        replace (r ^ 4 * (4 * s - 1) * (rho ^ 2) ^ 4) with (r ^ 4 * ((4 * s - 1) * (rho ^ 2) ^ 4)) by ring.
        apply Rmult_le_compat_l; [assumption|now apply quartic_grows_weakly]. }
      assert (K : k / 2 = delta).
      { assert (16 * delta ^ 2 * s ^ 4 <= 4 * k ^ 2 * s ^ 4) by lra.
        assert (16 * delta ^ 2 <= 4 * k ^ 2) by (apply Rmult_le_reg_r with (s ^ 4); lra). nra. }
      split; [assumption|].
      assert (I : r ^ 4 * (4 * s - 1) = 4 * k ^ 2 * s ^ 4)
        by (apply Rle_antisym; [assumption|rewrite <- K in Own; nra]).
      split; [|now apply in_own_ratio_equal].
      destruct B as [B|B]; [exfalso|rewrite <- B; lra].
      assert (G := quartic_grows s (rho ^ 2) A B).
      assert (0 < r ^ 4) by (assert (Q := r_positive); replace (r ^ 4) with (r ^ 2 * r ^ 2) by ring; nra).
      assert (L : r ^ 4 * ((4 * rho ^ 2 - 1) * s ^ 4) < r ^ 4 * ((4 * s - 1) * (rho ^ 2) ^ 4))
        by now apply Rmult_lt_compat_l.
      replace (r ^ 4 * ((4 * rho ^ 2 - 1) * s ^ 4)) with (r ^ 4 * (4 * rho ^ 2 - 1) * s ^ 4) in L by ring.
      replace (r ^ 4 * ((4 * s - 1) * (rho ^ 2) ^ 4)) with (r ^ 4 * (4 * s - 1) * (rho ^ 2) ^ 4) in L by ring.
      rewrite H, I, <- K in L; apply (Rlt_irrefl (4 * k ^ 2 * s ^ 4 * (rho ^ 2) ^ 4)).
      replace (16 * (rho ^ 2) ^ 4 * (k / 2) ^ 2 * s ^ 4) with (4 * k ^ 2 * s ^ 4 * (rho ^ 2) ^ 4) in L by field.
      exact L.
    - intros (K & Q & I).
      assert (s = rho ^ 2) as <- by (apply Rmult_eq_reg_r with S; lra).
      apply in_own_ratio_equal in I; rewrite I, <- K; field.
  Qed.

  Lemma sharp_bound_to_the_fourth : 0 <= sharp_bound rho delta /\
    (4 * rho ^ 2 - 1) * sharp_bound rho delta ^ 4 = 16 * (rho ^ 2) ^ 4 * delta ^ 2.
  Proof.
    assert (H := rho_at_least); unfold sharp_bound.
    destruct (fourth_root (4 * rho ^ 2 - 1)) as [P Q]; [lra|].
    set (w := Rpower (4 * rho ^ 2 - 1) (1 / 4)) in *.
    assert (D : 0 <= delta) by lra; assert (D2 := sqrt_pos delta); assert (D3 := pow2_sqrt delta D).
    split.
    - apply Rmult_le_pos; [|left; now apply Rinv_0_lt_compat].
      apply Rmult_le_pos; [lra|assumption].
    - replace (delta ^ 2) with (sqrt delta ^ 4) by (replace (sqrt delta ^ 4) with ((sqrt delta ^ 2) ^ 2) by ring;
        now rewrite D3).
      rewrite <- Q at 1; field; lra.
  Qed.

  Lemma sharp_bound_holds : r <= sharp_bound rho delta.
  Proof.
    destruct sharp_bound_to_the_fourth as [P Q]; assert (H := quartic_bound); assert (G := rho_at_least).
    apply at_most_of_fourth_powers; [assumption|].
    apply Rmult_le_reg_l with (4 * rho ^ 2 - 1); [lra|]; lra.
  Qed.

  Lemma sharp_bound_equal :
    r = sharp_bound rho delta <-> k / 2 = delta /\ r ^ 2 = rho ^ 2 * S /\ (T = S \/ U = S).
  Proof.
    rewrite <- quartic_bound_equal.
    destruct sharp_bound_to_the_fourth as [P Q]; assert (G := rho_at_least); split; intro H.
    - rewrite H; lra.
    - apply Rle_antisym; [apply sharp_bound_holds|].
      apply at_most_of_fourth_powers; [assumption|].
      apply Rmult_le_reg_l with (4 * rho ^ 2 - 1); [lra|]; lra.
  Qed.

  Lemma weak_bound_holds : r <= 2 * Rpower rho (3 / 2) * sqrt delta.
  Proof.
    assert (H := quartic_bound); assert (G := rho_at_least).
    assert (P : 0 < rho) by (destruct rho_nonnegative as [|<-]; [assumption|simpl in G; lra]).
    destruct (power_three_halves rho P) as [W W2]; set (w := Rpower rho (3 / 2)) in *.
    assert (D : 0 <= delta) by lra; assert (D2 := sqrt_pos delta); assert (D3 := pow2_sqrt delta D).
    apply at_most_of_fourth_powers; [apply Rmult_le_pos; lra|].
    replace ((2 * w * sqrt delta) ^ 4) with (16 * (w ^ 2) ^ 2 * (sqrt delta ^ 2) ^ 2) by ring.
    rewrite W2, D3.
    assert (R4 : 0 <= r ^ 4) by (apply pow_le; lra).
    apply Rmult_le_reg_r with (rho ^ 2); [now apply pow_lt|].
    apply Rle_trans with (r ^ 4 * (4 * rho ^ 2 - 1)); [apply Rmult_le_compat_l; lra|].
    apply Rle_trans with (1 := H); right; ring.
  Qed.
End Bound.

Lemma shortest_edge_turned : forall a b c, shortest_edge b c a = shortest_edge a b c.
Proof. intros; unfold shortest_edge, Rmin; repeat destruct Rle_dec; lra. Qed.

Lemma circumcircle_turned : forall a b c o r, circumcircle a b c o r -> circumcircle b c a o r.
Proof. intros a b c o r (A & B & C); repeat split; assumption. Qed.

Lemma two_edges_are_shortest_turned : forall a b c, two_edges_are_shortest b c a <-> two_edges_are_shortest a b c.
Proof. intros; unfold two_edges_are_shortest; rewrite shortest_edge_turned; tauto. Qed.

(* The theorems if ab is a shortest edge. *)
Section OneTriangle.
  Variables a b c o : point.
  Variables r rho delta : R.
  Hypothesis is_triangle : triangle a b c.
  Hypothesis is_circumcircle : circumcircle a b c o r.
  Hypothesis rho_bounds : ratio a b c r <= rho.
  Hypothesis delta_bounds : area a b c <= delta.
  Hypothesis ab_shortest : shortest_edge a b c = distance a b.

  Let S := square_distance a b.
  Let T := square_distance b c.
  Let U := square_distance c a.
  Let k := twice_area a b c.

  Lemma given : 0 < S /\ (S <= T /\ S <= U) /\
    4 * k ^ 2 = 2 * S * T + 2 * T * U + 2 * U * S - S ^ 2 - T ^ 2 - U ^ 2 /\ 0 < k /\
    4 * r ^ 2 * k ^ 2 = S * T * U /\ 0 <= r /\ 0 <= rho /\ r ^ 2 <= rho ^ 2 * S /\ k / 2 <= delta /\
    (r ^ 2 = rho ^ 2 * S <-> ratio a b c r = rho).
  Proof.
    assert (P : 0 < S) by (apply (edge_of_triangle_positive a b c); unfold triangle in is_triangle; lra).
    assert (D := distance_positive a b P).
    assert (N : 0 <= r) by (apply (radius_nonnegative o r a), is_circumcircle).
    assert (M := distance_squared a b); fold S in M.
    unfold ratio in *; rewrite ab_shortest in *.
    assert (Q : 0 <= r / distance a b) by (apply Rmult_le_pos; [assumption|left; now apply Rinv_0_lt_compat]).
    assert (E : r = r / distance a b * distance a b) by (field; lra).
    split; [assumption|]; split.
    { rewrite <- M; unfold T, U; rewrite <- !distance_squared.
      assert (B := distance_nonnegative b c); assert (C := distance_nonnegative c a).
      assert (distance a b <= distance b c /\ distance a b <= distance c a)
        by (rewrite <- ab_shortest; unfold shortest_edge, Rmin; repeat destruct Rle_dec; lra).
      split; nra. }
    split; [unfold k, S, T, U, twice_area, square_distance; ring|].
    split; [exact is_triangle|].
    split; [apply (circumradius_formula a b c o r is_circumcircle)|].
    split; [assumption|]. split; [lra|].
    split; [|split; [exact delta_bounds|]].
    - rewrite E, <- M, Rpow_mult_distr.
      apply Rmult_le_compat_r; [apply pow2_ge_0|]. apply pow_incr; lra.
    - rewrite <- M; split; intro H.
      + apply equal_of_squares; [assumption|lra|].
        apply Rmult_eq_reg_r with (distance a b ^ 2); [|apply Rgt_not_eq, pow_lt; assumption].
        rewrite <- Rpow_mult_distr, <- E; exact H.
      + rewrite E, H; ring.
  Qed.

  Lemma isosceles_here : (T = S \/ U = S) <-> two_edges_are_shortest a b c.
  Proof.
    destruct given as (P & (L1 & L2) & _).
    unfold two_edges_are_shortest; rewrite ab_shortest.
    assert (A := distance_squared a b); assert (B := distance_squared b c); assert (C := distance_squared c a).
    fold S in A; fold T in B; fold U in C.
    assert (A0 := distance_nonnegative a b); assert (B0 := distance_nonnegative b c).
    assert (C0 := distance_nonnegative c a).
    split.
    - intros [E|E]; [left|right; right]; split; try reflexivity; apply equal_of_squares; lra.
    - intros [(_ & E)|[(E & F)|(E & _)]].
      + left; rewrite <- A, <- B, E; reflexivity.
      + left; rewrite <- A, <- B, E; reflexivity.
      + right; rewrite <- A, <- C, E; reflexivity.
  Qed.

  Lemma conclusion :
    r <= 2 * Rpower rho (3 / 2) * sqrt delta /\ 1 / 3 <= rho ^ 2 /\ r <= sharp_bound rho delta /\
    (r = sharp_bound rho delta <-> ratio a b c r = rho /\ area a b c = delta /\ two_edges_are_shortest a b c).
  Proof.
    destruct given as (G1 & G2 & G3 & G4 & G5 & G6 & G7 & G8 & G9 & G10).
    split; [now apply (weak_bound_holds S T U k)|]. split; [now apply (rho_at_least S T U k r)|].
    split; [now apply (sharp_bound_holds S T U k)|].
    rewrite (sharp_bound_equal S T U k r rho delta) by assumption.
    rewrite G10, isosceles_here; unfold area; fold k; tauto.
  Qed.
End OneTriangle.

Lemma conclusion_of_triangle : forall a b c o r rho delta,
  triangle a b c -> circumcircle a b c o r -> ratio a b c r <= rho -> area a b c <= delta ->
  r <= 2 * Rpower rho (3 / 2) * sqrt delta /\ 1 / 3 <= rho ^ 2 /\ r <= sharp_bound rho delta /\
  (r = sharp_bound rho delta <-> ratio a b c r = rho /\ area a b c = delta /\ two_edges_are_shortest a b c).
Proof.
  intros a b c o r rho delta H K L M.
  assert (H1 := H); unfold triangle in H1; rewrite <- twice_area_turned in H1.
  assert (H2 := H1); rewrite <- twice_area_turned in H2.
  assert (K1 := circumcircle_turned _ _ _ _ _ K); assert (K2 := circumcircle_turned _ _ _ _ _ K1).
  assert (L1 := L); unfold ratio in L1; rewrite <- shortest_edge_turned in L1.
  assert (L2 := L1); rewrite <- shortest_edge_turned in L2.
  assert (M1 := M); unfold area in M1; rewrite <- twice_area_turned in M1.
  assert (M2 := M1); rewrite <- twice_area_turned in M2.
  destruct (Req_dec (shortest_edge a b c) (distance a b)) as [E|E]; [now apply (conclusion a b c o)|].
  destruct (Req_dec (shortest_edge a b c) (distance b c)) as [F|F].
  { rewrite <- shortest_edge_turned in F.
    assert (C := conclusion b c a o r rho delta H1 K1 L1 M1 F).
    rewrite two_edges_are_shortest_turned in C.
    unfold ratio, area in *; rewrite shortest_edge_turned, twice_area_turned in C; exact C. }
  assert (G : shortest_edge c a b = distance c a).
  { revert E F; unfold shortest_edge, Rmin; repeat destruct Rle_dec; lra. }
  assert (C := conclusion c a b o r rho delta H2 K2 L2 M2 G).
  do 2 rewrite two_edges_are_shortest_turned in C.
  unfold ratio, area in *; do 2 rewrite shortest_edge_turned in C; do 2 rewrite twice_area_turned in C; exact C.
Qed.

(* T3. *)
Theorem T3 : forall a b c o r rho delta,
  triangle a b c -> circumcircle a b c o r -> ratio a b c r <= rho -> area a b c <= delta ->
  r <= 2 * Rpower rho (3 / 2) * sqrt delta.
Proof. intros a b c o; intros; now apply (conclusion_of_triangle a b c o). Qed.

(* T3-sharp: the bound. *)
Theorem T3_sharp : forall a b c o r rho delta,
  triangle a b c -> circumcircle a b c o r -> ratio a b c r <= rho -> area a b c <= delta ->
  r <= sharp_bound rho delta.
Proof. intros a b c o; intros; now apply (conclusion_of_triangle a b c o). Qed.

(* T3-sharp: equality holds if and only if both bounds are attained and the two shorter sides are equal. *)
Theorem T3_sharp_equality : forall a b c o r rho delta,
  triangle a b c -> circumcircle a b c o r -> ratio a b c r <= rho -> area a b c <= delta ->
  (r = sharp_bound rho delta <-> ratio a b c r = rho /\ area a b c = delta /\ two_edges_are_shortest a b c).
Proof. intros a b c o; intros; now apply (conclusion_of_triangle a b c o). Qed.

(* T3-sharp: no triangle has a ratio below 1 / sqrt 3. *)
Theorem ratio_of_every_triangle : forall a b c o r,
  triangle a b c -> circumcircle a b c o r -> 1 / sqrt 3 <= ratio a b c r.
Proof.
  intros a b c o r H K.
  destruct (conclusion_of_triangle a b c o r _ _ H K (Rle_refl _) (Rle_refl _)) as (_ & L & _).
  assert (S := sqrt_lt_R0 3 ltac:(lra)); assert (S2 := pow2_sqrt 3 ltac:(lra)).
  assert (N : 0 <= ratio a b c r).
  { unfold ratio; apply Rmult_le_pos; [apply (radius_nonnegative o r a), K|].
    unfold triangle in H; left; apply Rinv_0_lt_compat; unfold shortest_edge.
    repeat apply Rmin_glb_lt; apply distance_positive; eapply edge_of_triangle_positive; apply Rgt_not_eq;
      [exact H|rewrite twice_area_turned; exact H|rewrite <- twice_area_turned in H; rewrite <- twice_area_turned in H;
       exact H]. }
  apply at_most_of_squares; [assumption|].
  replace ((1 / sqrt 3) ^ 2) with (1 / sqrt 3 ^ 2) by (field; lra); rewrite S2; exact L.
Qed.

(* T3-sharp: the bound grows with the ratio, from 1 / sqrt 3 on. *)
Theorem sharp_bound_grows : forall rho rho' delta, 0 < delta -> 1 / sqrt 3 <= rho -> rho < rho' ->
  sharp_bound rho delta < sharp_bound rho' delta.
Proof.
  intros u v delta D Hu Huv.
  assert (S := sqrt_lt_R0 3 ltac:(lra)); assert (S2 := pow2_sqrt 3 ltac:(lra)).
  assert (P : 0 < 1 / sqrt 3) by (apply Rdiv_lt_0_compat; lra).
  assert (U2 : 1 / 3 <= u ^ 2).
  { replace (1 / 3) with ((1 / sqrt 3) ^ 2) by (rewrite <- S2 at 2; field; lra). apply pow_incr; lra. }
  assert (UV : u ^ 2 < v ^ 2) by nra.
  assert (G := quartic_grows _ _ U2 UV); unfold sharp_bound.
  destruct (fourth_root (4 * u ^ 2 - 1)) as [A0 A]; [lra|].
  destruct (fourth_root (4 * v ^ 2 - 1)) as [B0 B]; [lra|].
  set (a := Rpower (4 * u ^ 2 - 1) (1 / 4)) in *; set (b := Rpower (4 * v ^ 2 - 1) (1 / 4)) in *.
  assert (E := sqrt_lt_R0 delta D).
  assert (L : u ^ 2 * b < v ^ 2 * a).
  { destruct (Rlt_or_le (u ^ 2 * b) (v ^ 2 * a)) as [|N]; [assumption|exfalso].
    assert (0 <= v ^ 2 * a) by (apply Rmult_le_pos; lra).
    assert (F := pow_incr _ _ 4 (conj H N)); rewrite !Rpow_mult_distr, A, B in F; lra. }
  apply Rmult_lt_reg_r with (a * b); [now apply Rmult_lt_0_compat|].
  replace (2 * u ^ 2 * sqrt delta / a * (a * b)) with (2 * sqrt delta * (u ^ 2 * b)) by (field; lra).
  replace (2 * v ^ 2 * sqrt delta / b * (a * b)) with (2 * sqrt delta * (v ^ 2 * a)) by (field; lra).
  apply Rmult_lt_compat_l; lra.
Qed.

(* T3-sharp: at every ratio from 1 / sqrt 3 on and every area, an isosceles triangle attains the bound. *)
Theorem isosceles_triangle_attains_the_sharp_bound : forall rho delta, 1 / sqrt 3 <= rho -> 0 < delta ->
  exists a b c o, triangle a b c /\ circumcircle a b c o (sharp_bound rho delta) /\
    ratio a b c (sharp_bound rho delta) = rho /\ area a b c = delta /\ two_edges_are_shortest a b c.
Proof.
  intros rho delta Hr D.
  assert (S := sqrt_lt_R0 3 ltac:(lra)); assert (S2 := pow2_sqrt 3 ltac:(lra)).
  assert (P : 0 < 1 / sqrt 3) by (apply Rdiv_lt_0_compat; lra).
  assert (R2 : 1 / 3 <= rho ^ 2).
  { replace (1 / 3) with ((1 / sqrt 3) ^ 2) by (rewrite <- S2 at 2; field; lra). apply pow_incr; lra. }
  set (g := sqrt (4 * rho ^ 2 - 1)).
  assert (G : 0 < g) by (apply sqrt_lt_R0; lra).
  assert (G2 : g ^ 2 = 4 * rho ^ 2 - 1) by (apply pow2_sqrt; lra).
  set (k := sqrt (delta / g)).
  assert (K : 0 < k) by (apply sqrt_lt_R0, Rdiv_lt_0_compat; assumption).
  assert (K2 : k ^ 2 = delta / g) by (apply pow2_sqrt; left; apply Rdiv_lt_0_compat; assumption).
  assert (Area : k ^ 2 * g = delta) by (rewrite K2; field; lra).
  set (a := (0, k) : point); set (b := (- (k * g), 0) : point); set (c := (k * g, 0) : point).
  set (r := 2 * rho ^ 2 * k); set (o := (0, k - r) : point).
  assert (KG : 0 < k * g) by now apply Rmult_lt_0_compat.
  assert (L : k ^ 2 + (k * g) ^ 2 = (2 * rho * k) ^ 2) by (rewrite !Rpow_mult_distr, G2; ring).
  assert (Dab : distance a b = 2 * rho * k).
  { unfold distance, square_distance, a, b; cbn [fst snd].
    replace ((- (k * g) - 0) ^ 2 + (0 - k) ^ 2) with (k ^ 2 + (k * g) ^ 2) by ring; rewrite L.
    apply sqrt_pow2; apply Rmult_le_pos; lra. }
  assert (Dca : distance c a = 2 * rho * k).
  { unfold distance, square_distance, a, c; cbn [fst snd].
    replace ((0 - k * g) ^ 2 + (k - 0) ^ 2) with (k ^ 2 + (k * g) ^ 2) by ring; rewrite L.
    apply sqrt_pow2; apply Rmult_le_pos; lra. }
  assert (Dbc : distance b c = 2 * (k * g)).
  { unfold distance, square_distance, b, c; cbn [fst snd].
    replace ((k * g - - (k * g)) ^ 2 + (0 - 0) ^ 2) with ((2 * (k * g)) ^ 2) by ring.
    apply sqrt_pow2; lra. }
  assert (Le : rho <= g) by (apply at_most_of_squares; [lra|rewrite G2; lra]).
  assert (Short : shortest_edge a b c = 2 * rho * k).
  { unfold shortest_edge; rewrite Dab, Dbc, Dca.
    assert (2 * rho * k <= 2 * (k * g)) by nra.
    unfold Rmin; repeat destruct Rle_dec; lra. }
  assert (RK : 0 < rho * k) by (apply Rmult_lt_0_compat; lra).
  assert (Ra : 0 < r) by (unfold r; nra).
  assert (T : triangle a b c) by (unfold triangle, twice_area, a, b, c; cbn [fst snd]; nra).
  assert (A : area a b c = delta)
    by (unfold area, twice_area, a, b, c; cbn [fst snd]; rewrite <- Area; field).
  assert (Q : ratio a b c r = rho) by (unfold ratio, r; rewrite Short; field; lra).
  assert (C : circumcircle a b c o r).
  { assert (W : (k * g) ^ 2 + (k - r) ^ 2 = r ^ 2)
      by (replace ((k - r) ^ 2) with (k ^ 2 - 2 * k * r + r ^ 2) by ring;
          replace ((k * g) ^ 2) with ((2 * rho * k) ^ 2 - k ^ 2) by lra; unfold r; ring).
    repeat split; unfold on_circle, distance, square_distance, o, a, b, c; cbn [fst snd];
      rewrite <- (sqrt_pow2 r) at 2 by lra; f_equal; lra. }
  assert (I : two_edges_are_shortest a b c) by (right; right; rewrite Short; split; assumption).
  assert (E : r = sharp_bound rho delta)
    by (apply (T3_sharp_equality a b c o r rho delta T C); [lra|lra|tauto]).
  exists a, b, c, o; rewrite <- E; tauto.
Qed.

(* T3: a bound with sqrt 2 in place of 2 is false at every ratio. *)
Theorem T3_with_root_two_is_false : forall rho delta, 1 / sqrt 3 <= rho -> 0 < delta ->
  sqrt 2 * Rpower rho (3 / 2) * sqrt delta < sharp_bound rho delta.
Proof.
  intros rho delta Hr D.
  assert (S := sqrt_lt_R0 3 ltac:(lra)); assert (S2 := pow2_sqrt 3 ltac:(lra)).
  assert (P : 0 < 1 / sqrt 3) by (apply Rdiv_lt_0_compat; lra).
  assert (R2 : 1 / 3 <= rho ^ 2).
  { replace (1 / 3) with ((1 / sqrt 3) ^ 2) by (rewrite <- S2 at 2; field; lra). apply pow_incr; lra. }
  unfold sharp_bound.
  destruct (fourth_root (4 * rho ^ 2 - 1)) as [A0 A]; [lra|].
  destruct (power_three_halves rho) as [B0 B]; [lra|].
  set (w := Rpower (4 * rho ^ 2 - 1) (1 / 4)) in *; set (v := Rpower rho (3 / 2)) in *.
  assert (E := sqrt_lt_R0 delta D); assert (T := sqrt_lt_R0 2 ltac:(lra)); assert (T2 := pow2_sqrt 2 ltac:(lra)).
  apply Rmult_lt_reg_r with (w / sqrt delta); [now apply Rdiv_lt_0_compat|].
  replace (2 * rho ^ 2 * sqrt delta / w * (w / sqrt delta)) with (2 * rho ^ 2) by (field; lra).
  replace (sqrt 2 * v * sqrt delta * (w / sqrt delta)) with (sqrt 2 * v * w) by (field; lra).
  destruct (Rlt_or_le (sqrt 2 * v * w) (2 * rho ^ 2)) as [|N]; [assumption|exfalso].
  assert (N0 : 0 <= 2 * rho ^ 2) by lra.
  assert (F := pow_incr _ _ 4 (conj N0 N)).
  replace ((sqrt 2 * v * w) ^ 4) with ((sqrt 2 ^ 2) ^ 2 * (v ^ 2) ^ 2 * w ^ 4) in F by ring.
  rewrite T2, A, B in F; assert (0 < rho ^ 6) by (apply pow_lt; lra).
  replace ((2 * rho ^ 2) ^ 4) with (16 * rho ^ 2 * rho ^ 6) in F by ring.
  replace (2 ^ 2 * (rho ^ 3) ^ 2 * (4 * rho ^ 2 - 1)) with (16 * rho ^ 2 * rho ^ 6 - 4 * rho ^ 6) in F by ring.
  lra.
Qed.
