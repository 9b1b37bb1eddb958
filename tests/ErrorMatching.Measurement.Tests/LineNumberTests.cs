namespace ErrorMatching.Measurement.Tests;

public class LineNumberTests
{
    [Theory]
    [InlineData("\n")]
    [InlineData("\r\n")]
    [InlineData("\r")]
    public void Lines_are_counted_through_quoted_breaks_and_blank_lines(string end)
    {
        var text = string.Join(end, "point,note,x_mm,y_mm", "A,\"one", "two", "three\",1,2", "", "B,,3,4", "C,\"x", "y\",bad,6");
        var error = Text.Refused(text);
        Assert.Equal((8, 3), (error.Place.Line, error.Place.Column));
        var file = Text.Read(text.Replace("bad", "5", StringComparison.Ordinal));
        Assert.Equal([2, 6, 7], file.Points.Select(p => p.Line));
    }

    [Fact]
    public void Skipped_lines_count()
    {
        var format = Text.Format("""{ "skipLines": 3 }""");
        var text = "Report \"of the day\r\nSerial number: 4711\r\n\r\npoint,x_mm,y_mm\r\nA,1,2\r\nB,1,\r\n";
        Assert.Equal((6, 3), (Text.Refused(text, format).Place.Line, Text.Refused(text, format).Place.Column));
        var file = Text.Read(text[..^6], format);
        Assert.Equal(5, file["A"].Line);
        Assert.Equal([new HeaderField("Serial number", "4711", 2)], file.HeaderFields);
    }

    [Fact]
    public void Skipping_everything_is_named() =>
        Assert.Equal(MeasurementError.MissingHeader, Text.Refused("a\nb\n", Text.Format("""{ "skipLines": 5 }""")).Code);

    [Fact]
    public void Long_files_keep_their_lines_across_the_parsers_buffers()
    {
        var lines = string.Concat(
            Enumerable.Range(1, 20_000).Select(i => FormattableString.Invariant(
                $"\"P{i}\",\"{i % 100}\",\"with \"\"quotes\"\"\nand a break\",{i % 7}.5\r\n")));
        var file = Text.Read("point,x_mm,note,y_mm\r\n" + lines);
        Assert.All(file.Points.Select((p, i) => (p, i)), t => Assert.Equal(2 + (2 * t.i), t.p.Line));
        Assert.Equal(20_000, file.Points.Count);
    }
}
