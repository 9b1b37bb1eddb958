namespace ErrorMatching.Geometry.Tests;

public sealed class ConformanceTests
{
    // JCGM 106:2012, 7.4: measured 13.6, u = 1.8, limits 12.5 and 16.3.
    [Fact]
    public void The_example_of_JCGM_106_has_its_printed_probability() =>
        Assert.Equal(0.66, Math.Round(Conformance.Probability(new(12.5, 16.3), 13.6, 1.8)!.Value, 2));

    // JCGM 106:2012, table 1: z = (limit - measured) / u for a single limit; the other one is far away.
    [Theory]
    [InlineData(0.80, 0.84)]
    [InlineData(0.90, 1.28)]
    [InlineData(0.95, 1.64)]
    [InlineData(0.99, 2.33)]
    [InlineData(0.999, 3.09)]
    public void The_table_of_JCGM_106_gives_the_guard_bands(double probability, double z)
    {
        var guard = DecisionRule.GuardBand(100 * (1 - probability)).GuardMm(0.01);

        Assert.Equal(z, Math.Round(guard / 0.01, 2));
        Assert.Equal(probability, Conformance.Probability(new(-10, 0.05), 0.05 - guard, 0.01)!.Value, 12);
        Assert.Equal(probability, Conformance.Probability(new(-0.05, 10), -0.05 + guard, 0.01)!.Value, 12);
    }

    [Theory]
    [InlineData(0, 1, 0.6826894921)] // one u on both sides
    [InlineData(0, 2, 0.9544997361)]
    [InlineData(1, 1, 0.4772498681)] // on a limit, the other one 2 u away
    [InlineData(-1, 1, 0.4772498681)]
    [InlineData(8, 1, 1.2798125e-12)] // the tail beyond 7 u has all its digits
    [InlineData(-8, 1, 1.2798125e-12)]
    public void Closed_forms(double measured, double limit, double expected) =>
        Assert.Equal(1, Conformance.Probability(new(-limit, limit), measured, 1)!.Value / expected, 6);

    [Fact]
    public void A_certain_value_conforms_or_does_not()
    {
        Assert.Equal(1, Conformance.Probability(new(-0.05, 0.05), 0.05, 0));
        Assert.Equal(0, Conformance.Probability(new(-0.05, 0.05), 0.0501, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => Conformance.Probability(new(0, 1), 0, -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Conformance.Probability(new(0, 1), 0, double.NaN));
    }

    [Fact]
    public void Limits_without_width_have_no_conformance() => Assert.Null(Conformance.Probability(ToleranceBand.Zero, 0, 0.01));

    [Fact]
    public void Before_and_after_are_the_same_question_about_part_and_mating_error()
    {
        var limits = new ToleranceBand(-0.02, 0.05);
        Assert.Equal(Conformance.Probability(limits, 0.03, 0.01), Conformance.Probability(limits.Opposite(), -0.03, 0.01));
    }

    [Fact]
    public void Independent_probabilities_multiply()
    {
        Assert.Equal(0.4, Conformance.OfIndependent([0.5, null, 0.8])!.Value, 15);
        Assert.Null(Conformance.OfIndependent([null]));
        Assert.Null(Conformance.OfIndependent([]));
    }

    [Fact]
    public void A_guard_band_moves_both_limits_inward_as_long_as_they_do_not_meet()
    {
        var rule = DecisionRule.GuardBand(5);
        var accepted = rule.AcceptanceLimits(new(-0.05, 0.03), 0.01)!;

        Assert.Equal(-0.05 + 0.016448536, accepted.LowerMm, 9);
        Assert.Equal(0.03 - 0.016448536, accepted.UpperMm, 9);
        Assert.Null(rule.AcceptanceLimits(new(-0.0164, 0.0164), 0.01));
        Assert.NotNull(rule.AcceptanceLimits(new(-0.0165, 0.0165), 0.01));
        Assert.Equal(ToleranceBand.Zero, rule.AcceptanceLimits(ToleranceBand.Zero, 0.01));
        Assert.Equal(new(-1, 2), DecisionRule.Simple.AcceptanceLimits(new(-1, 2), 5));
        Assert.Equal(0, DecisionRule.GuardBand(50).GuardMm(1), 12);
    }

    [Theory]
    [InlineData(0.009)]
    [InlineData(50.1)]
    [InlineData(double.NaN)]
    public void A_risk_has_a_range(double risk) => Assert.Throws<ArgumentOutOfRangeException>(() => DecisionRule.GuardBand(risk));
}
