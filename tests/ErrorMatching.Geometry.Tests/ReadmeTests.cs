using System.Runtime.CompilerServices;
using ErrorMatching.Testing;

namespace ErrorMatching.Geometry.Tests;

public class ReadmeTests
{
    [Fact]
    public void Example_does_what_its_comments_say()
    {
        // example
        // Two flanks of a notch, two probed points each, with a gauge good to 2 micrometres: the apex no ball can reach.
        var notch = Wedge.Fit([new(-30, 20), new(-12, 8)], [new(12, 8), new(30, 20)], pointUncertaintyMm: 0.002);
        Point2 apex = notch.Apex;                               // (0, 0)
        double opening = notch.IncludedAngle.Degrees;           // 112.62
        double apexKnownTo = notch.ApexStandardError.Y;         // 0.0031 mm

        // A circle of radius 6 that rounds the notch off touches each flank in one point.
        var fillet = new Circle2(new(0, 6 / Math.Sin(notch.IncludedAngle.Radians / 2)), 6);
        var touch = Intersect.LineCircle(notch.Second.Line, fillet);
        bool tangent = touch.Kind == IntersectionKind.Tangent;  // true

        // A deviation along a boundary: degree and smoothing are chosen by how well left-out points are predicted.
        double[] place = [0, 5, 10, 15, 20, 25, 30, 35];
        double[] deviation = [0.021, 0.019, 0.020, 0.022, 0.018, 0.020, 0.021, 0.019];
        var field = PolynomialFit.Fit(place, deviation, new PolynomialFitOptions { Ridge = null });
        int degree = field.Degree;                              // 0: a constant offset explains it
        double offset = field.Evaluate(17.5);                   // 0.02
        // example

        Assert.True(apex.DistanceTo(new(0, 0)) < 1e-12);
        Assert.Equal(112.62, opening, 2);
        // By hand: a flank is known at the apex to 0.002 sqrt(208 + 1300) / 21.63, slides the apex by that times 0.5547 / 0.9231 in y,
        // and there are two of them.
        Assert.Equal(0.00305, apexKnownTo, 5);
        Assert.True(tangent);
        Assert.Equal(0, degree);
        Assert.Equal(0.02, offset, 12);
    }

    [Fact]
    public void Readme_shows_the_example_that_is_tested() =>
        Assert.Contains(
            Example(), File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Geometry", "README.md")), StringComparison.Ordinal);

    private static string Example([CallerFilePath] string path = "")
    {
        var source = Repository.PathTo("tests", "ErrorMatching.Geometry.Tests", Path.GetFileName(path));
        var lines = File.ReadAllLines(source).SkipWhile(l => l.Trim() != "// example").Skip(1).TakeWhile(l => l.Trim() != "// example");
        return string.Join("\n", lines.Select(l => l.Length > 8 ? l[8..] : ""));
    }
}
