namespace ErrorMatching.Mating.Tests;

public sealed class ArcLengthFieldTests
{
    // Points that scatter without any course: the leave-one-out error alone takes high degrees now and then,
    // which swing out between the points and behind them.
    [Fact]
    public void Scatter_does_not_make_a_course_swing_out()
    {
        for (var seed = 0; seed < 300; seed++)
        {
            var random = new Random(seed);
            double[] along = [.. Enumerable.Range(0, 10).Select(i => 5.0 * i)];
            double[] values = [.. along.Select(_ => random.NextDouble() - 0.5)];
            var field = ArcLengthField.Smooth(along, values, null, null, 0);

            Assert.All(
                Enumerable.Range(-20, 140).Select(i => field.At(i / 2.0)),
                v => Assert.InRange(Math.Abs(v), 0, 2.001 * values.Max(Math.Abs)));
        }
    }

    [Fact]
    public void A_course_that_its_points_show_is_followed()
    {
        double[] along = [.. Enumerable.Range(0, 12).Select(i => 4.0 * i)];
        var field = ArcLengthField.Smooth(along, [.. along.Select(s => 0.1 * Math.Sin(s / 10))], null, null, 0);

        Assert.All(Enumerable.Range(0, 89).Select(i => i / 2.0), s => Assert.Equal(0.1 * Math.Sin(s / 10), field.At(s), 0.0005));
    }
}
