using System.Globalization;
using System.Text.Json;
using ErrorMatching.Freeform;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public class SurfaceFitTests
{
    private static readonly string Points = Repository.PathTo("samples", "surface-fit", "points.csv");
    private static readonly string Check = Repository.PathTo("samples", "surface-fit", "check.csv");

    [Theory]
    // Noise of 0.3 um on a surface that is quadratic both ways: d1 is what the poles do not follow, d2 what they do.
    [InlineData("through-curve-mesh", 2, 2, 3, 3)]
    [InlineData("through-curves", 2, 3, 3, 7)]
    [InlineData("fit-surface", 3, 3, 4, 4)]
    [InlineData("studio-surface", 3, 3, 10, 7)]
    [InlineData("tensor", 3, 3, 10, 7)]
    public void Each_method_says_its_net_and_its_errors(string method, int degreeU, int degreeV, int polesU, int polesV)
    {
        var fit = Shell.Json(0, "errormatch/surface-fit/1", "surface", "fit", Points, "--method", method, "--check", Check);
        Assert.Equal((method, 70), (fit.Text("method"), fit.GetProperty("count").GetInt32()));
        Assert.Equal(
            (degreeU, degreeV, polesU, polesV), (Whole(fit, "degreeU"), Whole(fit, "degreeV"), Whole(fit, "polesU"), Whole(fit, "polesV")));
        Assert.Equal(0, fit.GetProperty("breaks").GetArrayLength());
        foreach (var name in new[] { "d1", "d2" })
        {
            var (mean, max) = (fit.GetProperty(name).Number("meanUm"), fit.GetProperty(name).Number("maxUm"));
            Assert.True(mean <= max && max < 1.5 && mean < 0.3, $"{name} {mean} {max}");
        }

        Assert.InRange(fit.Number("leaveLineOutUm"), 0.1, 0.6);
    }

    [Fact]
    public void The_surface_is_written_as_a_nominal_one_with_its_break()
    {
        // Two parabolas that meet at x = 40.3 with one slope: a break in curvature between two grid lines.
        using var folder = new TemporaryFolder();
        var lines = from j in Enumerable.Range(0, 7)
                    from i in Enumerable.Range(0, 10)
                    let x = 75.0 * i / 9
                    select string.Create(CultureInfo.InvariantCulture, $"{i},{j},{x:R},{63.0 * j / 6:R},{Height(x):R}\n");
        var points = folder.File("points.csv", "i,j,x,y,z\n" + string.Concat(lines));
        Assert.Equal(0, Shell.Run("surface", "fit", points, "--out", folder["nominal"]).Exit);
        foreach (var name in new[] { "surface.stp", "surface.igs" })
        {
            var file = Path.Combine(folder["nominal"], name);
            var surface = SurfaceReader.Read(File.ReadAllBytes(file), file, null, true).Spline;
            Assert.All(
                Enumerable.Range(1, 74), x => Assert.Equal(Height(x), surface.ClosestPoint(new(x, 30, Height(x))).At.Position.Z, 0.0001));
        }

        static double Height(double x) => 20 - (0.002 * (x - 40.3) * (x - 40.3) * (x < 40.3 ? 1 : 3));
    }

    [Fact]
    public void Best_is_the_default_and_near_the_truth()
    {
        var fit = Shell.Json(0, "errormatch/surface-fit/1", "surface", "fit", Points, "--check", Check);
        Assert.Equal("best", fit.Text("method"));
        Assert.InRange(fit.GetProperty("d2").Number("meanUm"), 0, 0.15);
    }

    [Fact]
    public void A_break_of_the_curvature_is_named_with_its_place()
    {
        using var folder = new TemporaryFolder();
        // Flat up to x = 40, a parabola behind: the curvature jumps by 0.004 / mm inside a cell of the grid.
        var rows = Enumerable.Range(0, 70).Select(k => (I: k % 10, J: k / 10)).Select(n =>
        {
            var (x, y) = (n.I * 75 / 9.0, n.J * 10.5);
            var over = Math.Max(0, x - 40);
            return string.Create(CultureInfo.InvariantCulture, $"{n.I},{n.J},{x:R},{y:R},{24 + (0.002 * over * over):R}\n");
        });
        var place = Assert.Single(
            Shell.Json(0, "errormatch/surface-fit/1", "surface", "fit", folder.File("p.csv", "i,j,x,y,z\n" + string.Concat(rows)))
                .GetProperty("breaks")
                .EnumerateArray());
        Assert.Equal("u", place.Text("direction"));
        Assert.Equal(40, place.Number("x"), 0.5);
    }

    [Fact]
    public void Without_check_points_there_is_no_d2() =>
        Assert.False(Shell.Json(0, "errormatch/surface-fit/1", "surface", "fit", Points, "--method", "tensor").TryGetProperty("d2", out _));

    [Fact]
    public void Too_few_lines_to_leave_out_are_null()
    {
        using var folder = new TemporaryFolder();
        var fit = Shell.Json(
            0,
            "errormatch/surface-fit/1",
            "surface",
            "fit",
            folder.File("p.csv", "i,j,x,y,z\n0,0,0,0,1\n1,0,5,0,2\n0,1,0,4,3\n1,1,5,4,4\n"),
            "--method",
            "tensor");
        Assert.Equal(JsonValueKind.Null, fit.GetProperty("leaveLineOutUm").ValueKind);
    }

    [Theory]
    [InlineData("i,j,x,y,z\n0,0,0,0,1\n1,0,5,0,oops\n", "text-for-number", 3, 5)]
    [InlineData("i,j,x,y,z\n0,0,0,0,1\n0,0,5,0,2\n", "duplicate-point", 3, 1)]
    [InlineData("i,j,x,y,z\n0,0,0,0,1\n2,0,5,0,2\n", "missing-point", 3, 1)]
    public void Points_that_are_no_grid_are_named(string text, string code, int line, int column)
    {
        using var folder = new TemporaryFolder();
        var file = folder.File("p.csv", text);
        var error = Shell.Error(1, "surface", "fit", file);
        Assert.Equal((code, file, line, column), (error.Text("code"), error.Text("file"), Whole(error, "line"), Whole(error, "column")));
    }

    [Fact]
    public void Lines_that_fall_together_are_named()
    {
        using var folder = new TemporaryFolder();
        var file = folder.File("p.csv", "i,j,x,y,z\n0,0,0,0,1\n1,0,5,0,2\n0,1,0,0,1\n1,1,5,0,2\n");
        Assert.Equal(
            ("coincident-points", file),
            Shell.Error(1, "surface", "fit", file, "--method", "tensor") is var e ? (e.Text("code"), e.Text("file")) : default);
    }

    [Fact]
    public void A_method_without_this_name_is_a_wrong_command_line()
    {
        var error = Shell.Error(1, "surface", "fit", Points, "--method", "spline");
        Assert.Equal("command-line", error.Text("code"));
        Assert.Contains(
            "--method is spline; expected best, through-curve-mesh, through-curves, fit-surface, studio-surface, tensor.",
            error.Text("message"),
            StringComparison.Ordinal);
    }

    [Fact]
    public void Order_of_the_lines_does_not_matter()
    {
        using var folder = new TemporaryFolder();
        var lines = File.ReadAllLines(Points);
        var file = folder.File("p.csv", string.Concat(lines.Take(1).Concat(lines.Skip(1).Reverse()).Select(l => l + "\n")));
        var (a, b) = (
            Shell.Run("surface", "fit", Points, "--json", "--method", "through-curve-mesh").Output,
            Shell.Run("surface", "fit", file, "--json", "--method", "through-curve-mesh").Output);
        Assert.Equal(a.Replace(Points, file, StringComparison.Ordinal), b);
    }

    [Fact]
    public void Text_says_the_same_to_people()
    {
        var (exit, output, error) = Shell.Run("surface", "fit", Points, "--method", "through-curve-mesh", "--check", Check);
        Assert.Equal((0, ""), (exit, error));
        Assert.StartsWith($"Surface through-curve-mesh, 70 points of {Points}\n", output, StringComparison.Ordinal);
        var d2 = Shell.Json(0, "errormatch/surface-fit/1", "surface", "fit", Points, "--method", "through-curve-mesh", "--check", Check)
            .GetProperty("d2")
            .Number("meanUm");
        Assert.Contains(
            "\nd2 of the true surface           " + d2.ToString("0.0000", CultureInfo.InvariantCulture), output, StringComparison.Ordinal);
    }

    private static int Whole(JsonElement json, string name) => json.GetProperty(name).GetInt32();
}
