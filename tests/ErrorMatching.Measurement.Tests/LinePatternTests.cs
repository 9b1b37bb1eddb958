using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class LinePatternTests
{
    [Theory]
    [InlineData("TP{label} X{x} Y{y} Z{z}", "TP7 X  1.5  Y -2 Z- 3.\n")]
    [InlineData("{label},{x},{y},{z}", "%\r\n7, 1.5,-2.0, -3.0\r\n%\r\n")]
    [InlineData("{} {} {label} {x} {y} {z} {}", "28.11. 10:04 7 1.5 -2 -3 OK\n")]
    [InlineData("(point {label}: [{x}; {y}; {z}])", "Part 12\n(point 7: [1.5; -2; -3])\nend\n")]
    public void A_log_is_read_by_a_pattern_of_its_lines(string line, string text)
    {
        var point = Assert.Single(Text.Read(text, Format(line)).Points);
        Assert.Equal(("7", new Point3(1.5, -2, -3), true), (point.Label, point.Position, point.HasZ));
    }

    [Fact]
    public void A_pattern_without_a_label_gives_points_by_order()
    {
        var format = Text.Format("""{ "line": "X{x} Y{y}", "decimalComma": true, "unit": "inch", "skipLines": 1 }""");
        var file = Text.Read("X1 Y2\nX1,5 Y2\nX,25 Y4\n", format);
        Assert.True(file.IsByOrder);
        Assert.Equal([38.1, 6.35], file.Points.Select(p => p.Position.X));
        Assert.All(file.Points, p => Assert.False(p.HasZ));
    }

    // What shows itself to be another format is read by the pattern, too.
    [Fact]
    public void A_description_is_followed_to_the_letter() =>
        Assert.Equal(2, Text.Read("[PRB:1.0,2.0,3.0:0]\n", Format("[PRB:{x},{y},{z}:0]")).Points[0].Position.Y);

    [Theory]
    [InlineData("TP{label} X{x} Y{y}", "TP1 X1 Y2\nTP2 X1\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("TP{label} X{x} Y{y}", "TP1 X1 Y2\nTP1 X3 Y4\n", MeasurementError.DuplicatePoint, 2, 1)]
    [InlineData("TP{label} X{x} Y{y}", "TP1 X1 Y2e7\n", MeasurementError.BadStructure, 1, 1)]
    [InlineData("TP{label} X{x} Y{y}", "TP1 X1 Y20000000\n", MeasurementError.ImplausibleNumber, 1, 3)]
    [InlineData("{label} {x} {y}", "1 2 3\nend\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("TP{label} X{x} Y{y}", "nothing\n", MeasurementError.NoPoints, 1, 1)]
    public void A_line_that_must_match_and_does_not_is_named(string line, string text, string code, int at, int column)
    {
        var error = Text.Refused(text, Format(line));
        Assert.Equal((code, at, column), (error.Code, error.Place.Line, error.Place.Column));
    }

    [Theory]
    [InlineData("""{ "line": "X{x}" }""", "$.line")]
    [InlineData("""{ "line": "X{x} Y{y} {x}" }""", "$.line")]
    [InlineData("""{ "line": "X{x} Y{y} {a}" }""", "$.line")]
    [InlineData("""{ "line": "X{x} Y{y} }" }""", "$.line")]
    [InlineData("""{ "line": "X{x} Y{y}", "columns": { "x": 1 } }""", "$.columns")]
    [InlineData("""{ "line": "X{x} Y{y}", "delimiter": ";" }""", "$.delimiter")]
    [InlineData("""{ "kind": "grid", "line": "X{x} Y{y}" }""", "$.kind")]
    public void A_pattern_that_cannot_be_used_is_named(string json, string path)
    {
        var error = Assert.Throws<InputException>(() => MeasurementFormat.FromJson(json));
        Assert.Equal((MeasurementError.BadFormat, path), (error.Code, error.Place.Path));
    }

    [Fact]
    public void Random_bytes_are_read_or_named_and_nothing_else()
    {
        var (random, format) = (new Random(4711), Format("TP{label} X{x} Y{y} Z{z}"));
        var (read, named) = (0, 0);
        for (var i = 0; i < 5_000; i++)
        {
            var bytes = MutationTests.Mutate(Encoding.ASCII.GetBytes("TP1 X  1.5 Y -2 Z- 3.\r\nTP2 X1 Y2 Z3\n"), random);
            try
            {
                Assert.All(MeasurementReader.Read(bytes, "m.txt", format).Points, p => Assert.True(p.Position.IsFinite));
                read++;
            }
            catch (InputException e)
            {
                Assert.True(e.Place.Line >= 1 && e.Place.Column >= 1 && e.Code.Length > 0, e.Message);
                named++;
            }
        }

        Assert.True(read > 200 && named > 1000, $"{read} read, {named} named");
    }

    private static MeasurementFormat Format(string line) => Text.Format($$"""{ "line": "{{line}}" }""");
}
