using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Jobs that are made from a STEP file: the same as from the DXF drawing of the same outline.</summary>
public sealed class StepJobTests : IDisposable
{
    private static readonly string Program = Repository.PathTo("samples", "dovetail", "counterpart.nc");
    private static readonly string Dxf = Repository.PathTo("samples", "dovetail", "outline.dxf");

    private readonly string _folder = Directory.CreateTempSubdirectory("step").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData("key.stp", 1, StepSample.Millimeter)]
    [InlineData("key.STEP", 25.4, StepSample.Inch)]
    public void The_dovetail_as_a_plate_gives_the_job_of_its_drawing(string file, double unitMm, string unit)
    {
        var expected = Job(Dxf, "OUTLINE");
        var made = Job(Write(file, new StepSample().Plate([Dovetail()], -10, 0, unitMm).Bytes(unit)));
        Assert.Equal(expected.Features.Select(f => (f.Name, f.Kind, f.Points)), made.Features.Select(f => (f.Name, f.Kind, f.Points)));
        Assert.Equal(expected.Features.SelectMany(f => f.Blocks), made.Features.SelectMany(f => f.Blocks));
        Assert.Equal(expected.Frame.Mirror, made.Frame.Mirror);
        Assert.Equal(expected.Frame.Rotation.Degrees, made.Frame.Rotation.Degrees, 1e-6);
        Assert.Equal(0, (expected.Frame.Translation - made.Frame.Translation).Length, 1e-6);
        Assert.Equal(expected.ToolDiameterMm, made.ToolDiameterMm, 1e-6);
        Assert.Equal(unitMm, made.UnitMm);
        var (theirs, ours) = (Points(expected), Points(made));
        Assert.Equal(theirs.Count, ours.Count);

        // The table has six digits, of which the last one may be rounded the other way.
        Assert.All(theirs.Zip(ours), p => Assert.Equal(0, p.First.DistanceTo(p.Second), 1.5e-6));

        // What nobody cuts is said: the sides and the bottom that close the plate.
        Assert.Equal(3, made.Notes.Count(n => n.Contains("LINE is left out", StringComparison.Ordinal)));
        Assert.Contains(made.Notes, n => n.StartsWith("Counted once", StringComparison.Ordinal));
    }

    [Fact]
    public void The_face_is_asked_for_where_there_are_several()
    {
        var file = Write("key.stp", new StepSample().Plate([Dovetail()], -10, 0)
            .Plate([Square(new(300, 300), 40)], -10, -5).Bytes());
        var missing = Assert.Throws<InputException>(() => Make(file, null));
        Assert.Equal("layer-missing", missing.Code);
        var layers = Drawing.Read(file, null).Layers;
        Assert.Equal(2, layers.Count);
        Assert.StartsWith(
            $"it has the layers {layers[0]} (123 curves at Z 0, -10 mm), {layers[1]} (4 curves at Z -5, -10 mm). "
                + $"On what the program cuts, these can be laid: {layers[0]} (",
            missing.Problem,
            StringComparison.Ordinal);
        Assert.DoesNotContain($"{layers[1]} (1", missing.Problem, StringComparison.Ordinal);

        // A shell takes # for a comment.
        Assert.Equal(layers[0], Job(file, layers[0]).Layer);
        Assert.Equal(layers[0], Job(file, layers[0][1..]).Layer);
        Assert.Equal("layer-unknown", Assert.Throws<InputException>(() => Make(file, "##" + layers[0])).Code);
    }

    [Fact]
    public void Of_many_faces_those_with_the_longest_outlines_are_listed()
    {
        var sample = new StepSample();
        for (var i = 0; i < 30; i++)
        {
            sample.Plate([Square(new(50 * i, 0), 10 + i)], 0, 1);
        }

        var file = Write("many.stp", sample.Bytes());
        var missing = Assert.Throws<InputException>(() => Make(file, null));
        var layers = Drawing.Read(file, null).Layers;
        Assert.Contains(" and 6 with shorter outlines.", missing.Problem, StringComparison.Ordinal);
        Assert.DoesNotContain($"{layers[5]} (", missing.Problem, StringComparison.Ordinal);
        Assert.Contains($"{layers[6]} (4 curves at Z 1, 0 mm)", missing.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_model_in_another_unit_is_asked_about_and_not_guessed()
    {
        // The numbers are inches, and the file says millimeters.
        var file = Write("plate.stp", new StepSample().Plate([Polygon(OutlineJobTests.Outline)], -10, 0, 25.4).Bytes());
        var program = Write("program.nc", Encoding.ASCII.GetBytes(OutlineJobTests.Program));
        var refusal = Assert.Single(Make(file, null, null, program).Refusals);
        Assert.Equal("drawing-unit", refusal.Code);
        Assert.Contains("says that its unit is 1 mm", refusal.Message, StringComparison.Ordinal);
        Assert.EndsWith("give --unit inch.", refusal.Message, StringComparison.Ordinal);
        Assert.Equal(6, Make(file, null, 25.4, program).Result!.Features.Count);
    }

    [Fact]
    public void The_content_of_a_file_decides_and_then_its_extension()
    {
        var step = new StepSample().Plate([Square(new(0, 0), 10)], 0, 1).Bytes();
        Assert.Equal(4, Drawing.Read(Write("model.dxf", step), null).Curves.Count);
        Assert.Equal("no-step", Assert.Throws<InputException>(() => Drawing.Read(Write("a.stp", File.ReadAllBytes(Dxf)), null)).Code);
        var other = Assert.Throws<InputException>(() => Drawing.Read(Write("a.iges", step), null));
        Assert.Equal("not-a-drawing", other.Code);
        Assert.Contains(".dxf, .stp or .step", other.Problem, StringComparison.Ordinal);
    }

    // The outline of the sample, and three lines that close it below.
    private static List<DrawnCurve> Dovetail()
    {
        // In DXF, arcs are all counterclockwise.
        DrawnCurve[] drawn = [.. Drawing.Read(Dxf, null).Curves.Where(c => c.Layer == "OUTLINE")];
        var open = Assert.Single(OutlineChain.Join(drawn)).Curves;
        Point2[] below = [open[^1].To, new(open[^1].To.X, -60), new(open[0].From.X, -60), open[0].From];
        return [.. open, .. below.Zip(below.Skip(1), (a, b) => new DrawnLine("OUTLINE", "", a, b))];
    }

    private static List<DrawnCurve> Square(Point2 at, double side) =>
        Polygon([at, at + new Vector2(side, 0), at + new Vector2(side, side), at + new Vector2(0, side)]);

    private static List<DrawnCurve> Polygon(Point2[] corners) =>
        [.. corners.Select((p, i) => new DrawnLine("", "", p, corners[(i + 1) % corners.Length]))];

    private string Write(string file, byte[] bytes)
    {
        var path = Path.Combine(_folder, file);
        File.WriteAllBytes(path, bytes);
        return path;
    }

    private OutlineJob Job(string drawing, string? layer = null, double? unitMm = null) =>
        Assert.IsType<OutlineJob>(Make(drawing, layer, unitMm).Result);

    private Outcome<OutlineJob> Make(string drawing, string? layer, double? unitMm = null, string? program = null) => OutlineJob.Make(
        new(Path.Combine(_folder, "job.json"), drawing, program ?? Program, "fanuc") { Layer = layer, UnitMm = unitMm },
        TestContext.Current.CancellationToken);

    private static List<Point2> Points(OutlineJob job)
    {
        var points = MeasurementReader.Read(job.Theoretical, "theoretical.csv", MeasurementFormat.Points);
        return [.. points.Points.Select(p => new Point2(p.Position.X, p.Position.Y))];
    }
}
