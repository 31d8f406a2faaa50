(* The triangle with the least area for a circumradius and a shortest edge is isosceles: T3 of THEORY.md in the squares
   of lengths. *)
From Pardel Require Import Plane.

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
