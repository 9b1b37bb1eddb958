using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

/// <summary>Points that do not fit the others, in random parts with smooth errors of up to 0.2 mm and 2 µm of noise.</summary>
public sealed class SuspectSearchTests
{
    private const double Noise = 0.002;

    // Without a bad point, at most 1 of 100 has a false name; on an arc with waves of 0.2 mm, 4. Where the stated uncertainty is half or
    // a fifth of what is true, more have: no few points can tell a wrong reading from a rough surface.
    [Theory]
    [InlineData(ElementForm.Free, 1, 1, 0.01)]
    [InlineData(ElementForm.Free, 0.02, 1, 0.01)]
    [InlineData(ElementForm.Straight, 0.2, 1, 0.01)]
    [InlineData(ElementForm.Arc, 0.2, 1, 0.01)]
    [InlineData(ElementForm.Arc, 1, 1, 0.04)]
    [InlineData(ElementForm.Free, 0.2, 2, 0.05)]
    [InlineData(ElementForm.Straight, 0.2, 5, 0.11)]
    public void A_good_part_has_no_false_name(object form, double smooth, double noises, double most)
    {
        var named = Enumerable.Range(0, 300).Count(
            seed => Search(seed, 0, smooth, noises, (ElementForm)form).Found.Count > 0) / 300.0;
        Assert.True(named <= most, $"{named:0.000} have a false name, {most} may");
    }

    // A bore that is rough or not round: its own scatter is the yardstick.
    [Theory]
    [InlineData(8)]
    [InlineData(12)]
    [InlineData(24)]
    public void A_rough_bore_has_no_false_name(int count)
    {
        var random = new Random(29);
        var named = Enumerable.Range(0, 1000).Count(_ =>
        {
            var (points, values) = Bore(count, random, noises: 5);
            return SuspectSearch.AroundShape(points, values, Noise).Count > 0;
        });
        Assert.InRange(named, 0, 20);
    }

    // The smooth errors swing by as much as the distance of the points allows: five or six points over waves shorter than twice their
    // distance cannot be contradicted. With seven and more, they can.
    [Theory]
    [InlineData(1, 0.2, 7, 0.96)]
    [InlineData(0.2, 0.2, 5, 0.99)]
    [InlineData(0.2, 0.04, 7, 0.93)]
    [InlineData(0.2, 0.02, 7, 0.75)]
    [InlineData(1, 0.04, 9, 0.85)]
    public void A_bad_point_is_named(double smooth, double badMm, int fewest, double share)
    {
        var right = Enumerable.Range(0, 400).Select(seed => Search(seed, badMm, smooth)).Where(s => s.Points >= fewest)
            .Select(s => s.Found.Any(f => f.Row == s.Bad)).ToArray();
        var named = right.Count(r => r) / (double)right.Length;
        Assert.True(named >= share, $"{named:0.000} of {right.Length} named, {share} wanted");
    }

    // The counterpart of the paper's curve (table 5) bends at its last points: the end is not a wrong reading.
    [Fact]
    public void An_end_that_bends_is_not_named()
    {
        double[] along = [0, 5.7, 13.3, 23.5, 33.5, 41.1, 49.6, 58.7, 66.7, 71.2];
        double[] values = [0.291, 0.3099, 0.3066, 0.3027, 0.32, 0.309, 0.3073, 0.2995, 0.2699, 0.1995];
        var element = new BoundaryElement(new FeaturePass(0, 0, [0, along[^1]], []), 0, 0, ElementForm.Free);
        BoundaryRow[] rows = [.. along.Select((s, i) => new BoundaryRow([new(0, s, 1)], values[i]))];
        Assert.Empty(SuspectSearch.AlongCourse([element], rows, 0.0076));

        // In the middle, 0.2 mm are one.
        rows[4] = rows[4] with { ValueMm = values[4] - 0.2 };
        Assert.Equal(4, Assert.Single(SuspectSearch.AlongCourse([element], rows, 0.0076)).Row);
    }

    // A bore measured all around: a shift and a growth are no reason, one reading is.
    [Theory]
    [InlineData(8, 0.2)]
    [InlineData(12, 0.05)]
    [InlineData(12, -0.05)]
    public void A_bad_reading_of_a_bore_is_named(int count, double badMm)
    {
        var random = new Random(17);
        for (var run = 0; run < 50; run++)
        {
            var (points, values) = Bore(count, random);
            Assert.Empty(SuspectSearch.AroundShape(points, values, Noise));
            var bad = random.Next(count);
            values[bad] += badMm;
            var named = Assert.Single(SuspectSearch.AroundShape(points, values, Noise));
            Assert.Equal(bad, named.Row);
            Assert.Equal(badMm, named.OffMm, 6 * Noise);
        }
    }

    // Six readings of one kind and six of another: the bore is oval or stepped, and no reading is wrong.
    [Fact]
    public void Where_many_do_not_fit_none_is_named()
    {
        var (points, values) = Bore(10, new Random(3));
        foreach (var i in (int[])[1, 4, 7])
        {
            values[i] += 0.2;
        }

        Assert.Empty(SuspectSearch.AroundShape(points, values, Noise));
    }

    private static (RunPoint[] Points, double[] Values) Bore(int count, Random random, double noises = 1)
    {
        var points = Enumerable.Range(0, count).Select(i =>
        {
            var normal = new Vector2(Math.Cos(2 * Math.PI * i / count), Math.Sin(2 * Math.PI * i / count));
            return new RunPoint(0, i, new Point2(3, 5) + (normal * 10), Vector2.Zero, Vector2.Zero, normal)
            {
                Nominal = new(0, 0, 0, Vector2.Zero),
            };
        }).ToArray();
        var shift = new Vector2(random.NextDouble() - 0.5, random.NextDouble() - 0.5) * 0.2;
        return (points, [.. points.Select(p => shift.Dot(p.Normal) + 0.03 + (noises * Noise * Gauss(random)))]);
    }

    private static (IReadOnlyList<SuspectSearch.Suspect> Found, int Bad, int Points) Search(
        int seed, double badMm, double smooth, double noises = 1, ElementForm form = ElementForm.Free)
    {
        var (truth, along, values) = CourseTests.Curve(seed, noises * Noise);
        for (var i = 0; i < values.Length; i++)
        {
            values[i] = (smooth * truth(along[i])) + (values[i] - truth(along[i]));
        }

        var bad = new Random(seed + 1000).Next(values.Length);
        values[bad] += badMm;
        var element = new BoundaryElement(new FeaturePass(0, 0, [0, along[^1]], []), 0, 0, form)
        {
            Sweep = form == ElementForm.Arc ? 1.5 : 0
        };
        BoundaryRow[] rows = [.. along.Select((s, i) => new BoundaryRow([new(0, s, 1)], values[i]))];
        return (SuspectSearch.AlongCourse([element], rows, Noise), bad, values.Length);
    }

    private static double Gauss(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
