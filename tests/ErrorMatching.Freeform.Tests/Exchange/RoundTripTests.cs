using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>What is written comes back as the same doubles.</summary>
public sealed class RoundTripTests
{
    public static TheoryData<string> Formats => ["surface.igs", "surface.stp"];

    [Theory]
    [MemberData(nameof(Formats))]
    public void A_surface_comes_back_to_the_last_bit(string file)
    {
        for (var seed = 1; seed <= 40; seed++)
        {
            var surface = SurfaceSamples.Of(seed);
            var read = Read(Write(surface, file), file);
            Assert.Equal(surface.Name, read.Name);
            Assert.Equal(surface.Outside, read.Outside);
            Assert.True(read.Region.IsWhole);
            Same(surface.Spline, read.Spline);
        }
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void A_limited_surface_comes_back_with_its_polygons(string file)
    {
        for (var seed = 1; seed <= 20; seed++)
        {
            var surface = SurfaceSamples.Of(seed, limited: true);
            var read = Read(Write(surface, file), file);
            Same(surface.Spline, read.Spline);
            Assert.Equal(surface.Region.Loops.Count, read.Region.Loops.Count);
            for (var i = 0; i < surface.Region.Loops.Count; i++)
            {
                SameLoop(surface.Region.Loops[i], read.Region.Loops[i], mayDivide: file.EndsWith(".stp", StringComparison.Ordinal));
            }
        }
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void A_name_beyond_ascii_comes_back_as_far_as_the_format_has_it(string file)
    {
        var read = Read(Write(PaperDesign.One with { Name = "Fläche 'A\\' 曲面 1" }, file), file);
        Assert.Equal(file.EndsWith(".stp", StringComparison.Ordinal) ? "Fläche 'A\\' 曲面 1" : "Fl_che 'A\\' __ 1", read.Name);
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void Knots_that_are_not_clamped_come_back(string file)
    {
        var knots = new KnotVector(2, [-2, -1, 0, 1, 2, 3, 4]);
        Point3[] poles = [.. Enumerable.Range(0, 16).Select(n => new Point3(10.0 * (n / 4), 10.0 * (n % 4), 0.1 * (n % 3)))];
        var surface = new PartSurface("S", new(knots, knots, poles), SurfaceRegion.Whole, 1);
        Same(surface.Spline, Read(Write(surface, file), file).Spline);
    }

    [Theory]
    [InlineData("CONFIG_CONTROL_DESIGN")]
    [InlineData("AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }")]
    [InlineData("AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }")]
    public void A_surface_is_read_from_each_application_protocol(string schema)
    {
        var text = Encoding.ASCII.GetString(StepWriter.Write(PaperDesign.Three));
        var from = text.IndexOf("FILE_SCHEMA", StringComparison.Ordinal);
        text = text[..from] + $"FILE_SCHEMA(('{schema}'))" + text[text.IndexOf(';', from)..];
        Assert.Equal(
            PaperDesign.Three.Spline.Poles.ToArray(),
            SurfaceReader.Read(Encoding.ASCII.GetBytes(text), "surface.stp", null, true).Spline.Poles.ToArray());
    }

    [Fact]
    public void Records_of_IGES_have_eighty_columns()
    {
        var lines = System.Text.Encoding.ASCII.GetString(IgesWriter.Write(SurfaceSamples.Of(3, limited: true))).TrimEnd('\n').Split('\n');
        Assert.All(lines, l => Assert.Equal(80, l.Length));
    }

    // Each corner comes back to the last bit. A side that is straight in the parameters is bent in space:
    // STEP has more edges for it, whose ends lie on it.
    private static void SameLoop(IReadOnlyList<Point2> written, IReadOnlyList<Point2> read, bool mayDivide)
    {
        var next = 0;
        foreach (var point in read)
        {
            if (next < written.Count && point == written[next])
            {
                next++;
                continue;
            }

            Assert.True(mayDivide && next > 0, $"{point} was not written");
            var (from, to) = (written[next - 1], written[next % written.Count]);
            Assert.True(
                (point - from).Length + (to - point).Length - (to - from).Length < 1e-9,
                $"{point} lies beside the side from {from} to {to}");
        }

        Assert.Equal(written.Count, next);
    }

    private static byte[] Write(PartSurface surface, string file) =>
        file.EndsWith(".igs", StringComparison.Ordinal) ? IgesWriter.Write(surface) : StepWriter.Write(surface);

    private static PartSurface Read(byte[] bytes, string file) => SurfaceReader.Read(bytes, file, entity: null, outsideIsUp: true);

    private static void Same(SplineSurface expected, SplineSurface actual)
    {
        Assert.Equal(expected.KnotsU, actual.KnotsU);
        Assert.Equal(expected.KnotsV, actual.KnotsV);
        Assert.Equal(expected.Poles.ToArray(), actual.Poles.ToArray());
        Assert.Equal(expected.Weights.ToArray(), actual.Weights.ToArray());
    }
}
