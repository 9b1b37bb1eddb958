using System.Globalization;
using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public class FitTests
{
    [Theory]
    [InlineData("Filip", 10, 14)]
    [InlineData("Wampler1", 5, 14)]
    [InlineData("Wampler5", 5, 13)]
    [InlineData("Pontius", 2, 13)]
    public void Certified_polynomials_keep_their_digits_from_file_to_json(string name, int degree, int digits)
    {
        using var folder = new TemporaryFolder();
        var (csv, certified, errors) = Nist(name);
        var fit = Shell.Json(
            0,
            "errormatch/fit-polynomial/1",
            "fit",
            "polynomial",
            folder.File("p.csv", csv),
            "--degree",
            degree.ToString(CultureInfo.InvariantCulture));
        Assert.Equal((degree, 0), (fit.GetProperty("degree").GetInt32(), fit.Number("ridge")));
        AssertDigits(certified, Numbers(fit, "coefficients"), digits);
        AssertDigits(errors, Numbers(fit, "standardErrors"), digits - 1);
        Assert.Equal(csv.Split('\n').Length - 2, fit.GetProperty("residuals").GetArrayLength());
    }

    [Fact]
    public void Decimals_are_fitted_as_written_not_as_doubles_hold_them()
    {
        using var folder = new TemporaryFolder();
        // On a line as decimals; the nearest doubles of 0.1, 0.4, 0.7 and 1.0 miss it by up to 2e-17.
        var fit = Shell.Json(
            0,
            "errormatch/fit-polynomial/1",
            "fit",
            "polynomial",
            folder.File("p.csv", "x,y\n0.1,0.1\n0.2,0.4\n0.3,0.7\n0.4,1.0\n"),
            "--degree",
            "1");
        Assert.All(Numbers(fit, "residuals"), r => Assert.True(Math.Abs(r) < 1e-29));
    }

    [Fact]
    public void A_certified_line_comes_out_of_ordinary_least_squares()
    {
        using var folder = new TemporaryFolder();
        var (csv, certified, errors) = Nist("Norris");
        var fit = Shell.Json(0, "errormatch/fit-line/1", "fit", "line", folder.File("p.csv", csv), "--method", "ols");
        AssertDigits(certified, [fit.Number("intercept"), fit.Number("slope")], 11);
        AssertDigits(errors, [fit.Number("interceptStandardError"), fit.Number("slopeStandardError")], 10);
        // Residual standard deviation of Norris, as certified.
        AssertDigits([0.884796396144373], [fit.Number("residualStandardDeviation")], 10);
    }

    [Fact]
    public void Total_least_squares_is_the_default_and_has_no_equation()
    {
        using var folder = new TemporaryFolder();
        // A square's corners stretched along 45 degrees: by symmetry the line is y = x, each point sqrt(1/2) off it.
        var fit = Shell.Json(0, "errormatch/fit-line/1", "fit", "line", folder.File("p.csv", "x,y\n0,1\n1,0\n9,10\n10,9\n"));
        Assert.Equal("tls", fit.Text("method"));
        Assert.Equal(45, fit.Number("angleDeg"), 1e-12);
        Assert.Equal(9 * Math.Sqrt(2), fit.Number("length"), 1e-12);
        Assert.All(Numbers(fit, "residuals"), r => Assert.Equal(Math.Sqrt(0.5), Math.Abs(r), 1e-12));
        // Four residuals of sqrt(1/2), two degrees of freedom.
        Assert.Equal(1, fit.Number("residualStandardDeviation"), 1e-12);
        Assert.False(fit.TryGetProperty("slope", out _));
    }

    [Fact]
    public void A_circle_through_points_all_around_comes_out()
    {
        using var folder = new TemporaryFolder();
        // Four points of the circle about (3, -2) of radius 5 pushed out and in by turns by 0.1: symmetry keeps center and radius.
        var fit = Shell.Json(
            0, "errormatch/fit-circle/1", "fit", "circle", folder.File("p.csv", "x_mm,y_mm\n8.1,-2\n3,2.9\n-2.1,-2\n3,-6.9\n"));
        Assert.Equal(
            (3, -2, 5),
            (
                Math.Round(fit.GetProperty("center").Number("x"), 10),
                Math.Round(fit.GetProperty("center").Number("y"), 10),
                Math.Round(fit.Number("radius"), 10)));
        Assert.Equal([0.1, -0.1, 0.1, -0.1], Numbers(fit, "residuals").Select(r => Math.Round(r, 10)));
        // Four residuals of 0.1, one degree of freedom.
        Assert.Equal(0.2, fit.Number("residualStandardDeviation"), 1e-10);
    }

    [Fact]
    public void Automatic_choices_are_reported()
    {
        using var folder = new TemporaryFolder();
        var csv = "x,y\n"
            + string.Concat(
                Enumerable.Range(0, 12).Select(i => FormattableString.Invariant(
                    $"{i},{(2 * i * i) - i + (i % 2 == 0 ? 0.001 : -0.001)}\n")));
        var fit = Shell.Json(
            0, "errormatch/fit-polynomial/1", "fit", "polynomial", folder.File("p.csv", csv), "--degree", "auto", "--ridge", "auto");
        Assert.Equal(2, fit.GetProperty("degree").GetInt32());
        Assert.True(fit.Number("leaveOneOutRms") is > 0.001 and < 0.002);
    }

    [Fact]
    public void No_left_out_error_is_null()
    {
        using var folder = new TemporaryFolder();
        var fit = Shell.Json(
            0, "errormatch/fit-polynomial/1", "fit", "polynomial", folder.File("p.csv", "x,y\n0,1\n1,3\n"), "--degree", "1");
        Assert.Equal(JsonValueKind.Null, fit.GetProperty("leaveOneOutRms").ValueKind);
        Assert.Equal([1, 2], Numbers(fit, "coefficients"));
    }

    [Fact]
    public void A_value_outside_the_points_is_a_warning()
    {
        using var folder = new TemporaryFolder();
        // y = x^2 - 1 off by up to 0.001.
        var file = folder.File("p.csv", "x,y\n-2,3.001\n-1,-0.001\n0,-1\n1,0.001\n2,2.999\n3,8\n");
        string[] line = ["fit", "polynomial", file, "--degree", "2", "--uncertainty", "0.001", "--at", "-2,1.5,3,3.5"];
        var fit = Shell.Json(0, "errormatch/fit-polynomial/1", line);
        var values = fit.GetProperty("values").EnumerateArray().ToArray();
        Assert.Equal([false, false, false, true], values.Select(v => v.GetProperty("outside").GetBoolean()));
        Assert.All(values, v => Assert.Equal(Math.Pow(v.Number("x"), 2) - 1, v.Number("y"), 0.005));
        Assert.True(values[3].Number("standardError") > values[1].Number("standardError"));
        Assert.Equal([-2, 3], Numbers(fit, "extent"));
        var code = Assert.Single(fit.GetProperty("warningCodes").EnumerateArray());
        Assert.Equal("outside-points", code.Text("code"));
        Assert.Equal(["3.5", "-2", "3"], code.GetProperty("values").EnumerateArray().Select(v => v.GetString()));
        var sentence = Assert.Single(fit.GetProperty("warnings").EnumerateArray()).GetString();
        Assert.StartsWith("x = 3.5 is outside the points", sentence, StringComparison.Ordinal);
        var (exit, output, _) = Shell.Run(line);
        Assert.Equal(0, exit);
        Assert.Contains("\nWarning: " + sentence + "\n", output, StringComparison.Ordinal);
        Assert.Contains("outside the points\n", output, StringComparison.Ordinal);
    }

    [Fact]
    public void Standard_errors_that_the_points_do_not_show_are_a_warning_unless_the_uncertainty_is_stated()
    {
        using var folder = new TemporaryFolder();
        string[] line = ["fit", "polynomial", folder.File("p.csv", "x,y\n0,1\n1,3\n"), "--degree", "1"];
        var fit = Shell.Json(0, "errormatch/fit-polynomial/1", line);
        Assert.Equal("nothing-left", Assert.Single(fit.GetProperty("warningCodes").EnumerateArray()).Text("code"));
        fit = Shell.Json(0, "errormatch/fit-polynomial/1", [.. line, "--uncertainty", "0.002"]);
        Assert.Empty(fit.GetProperty("warnings").EnumerateArray());
        // y at 0 is as uncertain as the point there; the slope as the difference of two points.
        AssertDigits([0.002, 0.002 * Math.Sqrt(2)], Numbers(fit, "standardErrors"), 12);
    }

    [Fact]
    public void Stated_uncertainty_tells_noise_from_shape()
    {
        using var folder = new TemporaryFolder();
        string[] line = ["fit", "polynomial", folder.File("p.csv", "x,y\n0,0.004\n10,-0.005\n20,0.006\n30,-0.003\n"), "--degree", "auto"];
        Assert.Equal(3, Degree("0.0002"));
        Assert.Equal(0, Degree("0.01"));

        int Degree(string uncertainty) =>
            Shell.Json(0, "errormatch/fit-polynomial/1", [.. line, "--uncertainty", uncertainty]).GetProperty("degree").GetInt32();
    }

    [Theory]
    [InlineData("line", "1,1\n", "too-few-points")]
    [InlineData("line", "1,1\n1,1\n", "coincident-points")]
    [InlineData("line --method ols", "1,1\n1,2\n", "rank-deficient")]
    [InlineData("circle", "1,1\n2,2\n3,3\n", "collinear-points")]
    [InlineData("polynomial --degree 2", "1,1\n2,2\n", "too-few-points")]
    [InlineData("polynomial --degree 2", "1,1\n2,2\n1,3\n", "rank-deficient")]
    public void Points_that_do_not_determine_a_fit_are_exit_1(string verb, string points, string code)
    {
        using var folder = new TemporaryFolder();
        var file = folder.File("p.csv", "x,y\n" + points);
        var words = verb.Split(' ');
        var error = Shell.Error(1, ["fit", words[0], file, .. words[1..]]);
        Assert.Equal((code, file), (error.Text("code"), error.Text("file")));
        Assert.StartsWith(file + ": ", Shell.Run(["fit", words[0], file, .. words[1..]]).Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Text_shows_points_as_they_were_written()
    {
        using var folder = new TemporaryFolder();
        var file = folder.File("p.csv", "x,y\n0,1.10\n1,3.1\n\n2,5.1000\n");
        var (exit, output, _) = Shell.Run("fit", "polynomial", file, "--degree", "1");
        Assert.Equal(0, exit);
        Assert.StartsWith($"Polynomial of degree 1, ridge weight 0, 3 points of {file}\n", output, StringComparison.Ordinal);
        Assert.Contains("\nline  x       y", output, StringComparison.Ordinal);
        Assert.Contains("\n   5  2  5.1000", output, StringComparison.Ordinal);
        Assert.DoesNotContain('\r', output);
    }

    private static double[] Numbers(JsonElement json, string name) =>
        [.. json.GetProperty(name).EnumerateArray().Select(e => e.GetDouble())];

    // As the log relative error of McCullough (1998): the number of certified digits that agree.
    private static void AssertDigits(double[] certified, double[] actual, int digits)
    {
        Assert.Equal(certified.Length, actual.Length);
        Assert.All(
            certified.Zip(actual),
            p => Assert.True(
                Math.Abs(p.Second - p.First) <= Math.Pow(10, -digits) * Math.Max(Math.Abs(p.First), p.First == 0 ? 1 : 0),
                $"{p.First:R} certified, {p.Second:R} found"));
    }

    // The certified files state "Bn  estimate  standard error" and, behind a line "Data: y x", the data.
    private static (string Csv, double[] Certified, double[] Errors) Nist(string name)
    {
        string[][] lines = [
            .. File.ReadLines(Repository.PathTo(
                "tests",
                "ErrorMatching.Geometry.Tests",
                "Data",
                "Nist",
                name + ".dat")).Select(l => l.Split(default(char[]), StringSplitOptions.RemoveEmptyEntries))];
        var start = Array.FindIndex(lines, w => w is ["Data:", "y", "x"]);
        var certified = lines[..start].Where(w => w is [['B', >= '0' and <= '9', ..], _, _]).ToArray();
        var data = lines[(start + 1)..].Where(w => w.Length == 2).Select(w => $"{w[0]},{w[1]}\n");
        return ("y,x\n" + string.Concat(data), [.. certified.Select(w => Parse(w[1]))], [.. certified.Select(w => Parse(w[2]))]);

        static double Parse(string text) => double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture);
    }
}
