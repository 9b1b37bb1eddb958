using System.Text;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Cell.Tests;

public sealed class CorrectionSumsTests
{
    // Multiples of 1/1024 mm add without rounding, so laws hold to the last bit.
    private static readonly Gen<double> Millimeters = Gen.Choose(-1024, 1024).Select(n => n / 1024.0);

    private static readonly Gen<PointCorrection[]> Corrections = Gen.SubListOf("1", "2a", "3b", "ü").SelectMany(points =>
        Gen.CollectToArray(
            points, point => from x in Millimeters from y in Millimeters from z in Millimeters select new PointCorrection(point, x, y, z)));

    [Fact]
    public void Sums_come_back_from_their_document_to_the_last_bit() => Prop.ForAll(Arb.From(Corrections), corrections =>
    {
        var sums = CorrectionSums.None.Plus(corrections).Plus([new("third", 1.0 / 3, -1e-17, Math.PI)]);
        var json = sums.ToJson();
        var back = CorrectionSums.FromJson(json);
        return back.Points.SequenceEqual(sums.Points) && back.ToJson().AsSpan().SequenceEqual(json);
    }).QuickCheckThrowOnFailure();

    [Fact]
    public void Order_of_corrections_changes_no_sum() => Prop.ForAll(Arb.From(Gen.Two(Corrections)), pair =>
    {
        var (one, other) = pair;
        return Ordered(CorrectionSums.None.Plus(one).Plus(other)).SequenceEqual(Ordered(CorrectionSums.None.Plus(other).Plus(one)));
    }).QuickCheckThrowOnFailure();

    [Fact]
    public void A_correction_taken_back_leaves_zero() => Prop.ForAll(Arb.From(Corrections), corrections =>
        (
            CorrectionSums.None.Plus(corrections).Plus(
                [.. corrections.Select(c => new PointCorrection(c.Point, -c.X, -c.Y, -c.Z))]).Largest?.LengthMm
                ?? 0) == 0).QuickCheckThrowOnFailure();

    [Fact]
    public void Largest_sum_is_the_longest_vector()
    {
        var sums = CorrectionSums.None.Plus([new("a", 0.03, 0.04, 0), new("b", -0.06, 0, 0)]).Plus([new("a", 0.03, 0.04, 0)]);
        Assert.Equal(("a", 0.1), (sums.Largest!.Point, Math.Round(sums.Largest.LengthMm, 12)));
        Assert.Null(CorrectionSums.None.Largest);
    }

    [Fact]
    public void A_point_corrected_twice_at_once_is_a_mistake() =>
        Assert.Throws<ArgumentException>(() => CorrectionSums.None.Plus([new("a", 1, 0, 0), new("a", 1, 0, 0)]));

    [Theory]
    [InlineData("")]
    [InlineData("[]")]
    [InlineData("{}")]
    [InlineData("""{"schema":"errormatch/cell-sums/2","points":[]}""")]
    [InlineData("""{"schema":"errormatch/cell-sums/1"}""")]
    [InlineData("""{"schema":"errormatch/cell-sums/1","points":[{"point":"1","x":1,"y":1}]}""")]
    [InlineData("""{"schema":"errormatch/cell-sums/1","points":[{"point":null,"x":1,"y":1,"z":0}]}""")]
    [InlineData("""{"schema":"errormatch/cell-sums/1","points":[{"point":"1","x":"1","y":1,"z":0}]}""")]
    [InlineData("""{"schema":"errormatch/cell-sums/1","points":[{"point":"1","x":1e999,"y":1,"z":0}]}""")]
    [InlineData("""{"schema":"errormatch/cell-sums/1","points":[{"point":"1","x":1,"y":1,"z":0},{"point":"1","x":1,"y":1,"z":0}]}""")]
    public void Another_document_is_refused(string json) =>
        Assert.Throws<InvalidDataException>(() => CorrectionSums.FromJson(Encoding.UTF8.GetBytes(json)));

    private static IEnumerable<PointCorrection> Ordered(CorrectionSums sums) => sums.Points.OrderBy(p => p.Point, StringComparer.Ordinal);
}
