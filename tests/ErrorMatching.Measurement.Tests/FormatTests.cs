using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class FormatTests
{
    [Fact]
    public void Named_formats_are_found_by_name()
    {
        Assert.Same(MeasurementFormat.Points, Text.Format("\"points\""));
        Assert.Same(MeasurementFormat.FeatureTable, Text.Format("\"feature-table\""));
        Assert.Equal("feature-table", MeasurementFormat.FeatureTable.Kind);
    }

    [Fact]
    public void Members_left_out_are_those_of_the_named_format()
    {
        Assert.Equal(MeasurementFormat.Points, Text.Format("{}"));
        Assert.Equal(MeasurementFormat.Points with { Unit = LengthUnit.Inch }, Text.Format("""{ "unit": "inch" }"""));
        Assert.Equal(MeasurementFormat.FeatureTable, Text.Format("""{ "kind": "feature-table", /* comment */ }"""));
    }

    [Fact]
    public void A_shops_own_format_is_read()
    {
        var format = Text.Format(
            """{ "delimiter": ";", "decimalComma": true, "columns": { "label": "Nr", "x": "X-Wert", "y": 4, "z": null } }""");
        Assert.Equal(new Point3(-32.067, 76.005, 0), Text.Read("Nr;X-Wert;Bemerkung;Y;z_mm\n1;-32,067;;76,005;9\n", format)["1"].Position);
    }

    [Fact]
    public void Positions_alone_need_no_header()
    {
        var format = Text.Format("""{ "delimiter": "\t", "columns": { "label": 1, "x": 2, "y": 3, "z": 4 } }""");
        Assert.Equal((new Point3(1, 2, 3), 1), Text.Read("A\t1\t2\t3\n", format)["A"] is var p ? (p.Position, p.Line) : default);
        var error = Text.Refused("A\t1\t2\n", format);
        Assert.Equal((MeasurementError.MissingColumn, 1), (error.Code, error.Place.Line));
        Assert.Equal(
            (MeasurementError.TextForNumber, 2, 3),
            Text.Refused("A\t1\t2\t3\nB\t1\tx\t3\n", format) is var e ? (e.Code, e.Place.Line, e.Place.Column) : default);
    }

    [Fact]
    public void Positions_may_leave_z_to_a_name() =>
        Assert.False(Text.Read("A,1,2\n", Text.Format("""{ "columns": { "label": 1, "x": 2, "y": 3 } }""")).Points[0].HasZ);

    [Theory]
    [InlineData("\"cmm\"", "$")]
    [InlineData("7", "$")]
    [InlineData("not json", "$")]
    [InlineData("""{ "kind": "point" }""", "$.kind")]
    [InlineData("""{ "unit": "\ud800" }""", "$")]
    [InlineData("""{ "\ud800": 1 }""", "$")]
    [InlineData("""{ "kind": 3 }""", "$.kind")]
    [InlineData("""{ "separator": ";" }""", "$.separator")]
    [InlineData("""{ "unit": "mm", "unit": "inch" }""", "$")]
    [InlineData("""{ "unit": "cm" }""", "$.unit")]
    [InlineData("""{ "encoding": "ebcdic" }""", "$.encoding")]
    [InlineData("""{ "delimiter": "." }""", "$.delimiter")]
    [InlineData("""{ "decimalComma": "yes" }""", "$.decimalComma")]
    [InlineData("""{ "skipLines": -1 }""", "$.skipLines")]
    [InlineData("""{ "skipLines": 1.5 }""", "$.skipLines")]
    [InlineData("""{ "maxBytes": 0 }""", "$.maxBytes")]
    [InlineData("""{ "maxPoints": 1e99 }""", "$.maxPoints")]
    [InlineData("""{ "columns": [] }""", "$.columns")]
    [InlineData("""{ "columns": { "x": "" } }""", "$.columns.x")]
    [InlineData("""{ "columns": { "x": 0 } }""", "$.columns.x")]
    [InlineData("""{ "columns": { "x": null } }""", "$.columns.x")]
    [InlineData("""{ "columns": { "actual": "a" } }""", "$.columns.actual")]
    [InlineData("""{ "kind": "feature-table", "columns": { "x": "a" } }""", "$.columns.x")]
    public void A_wrong_description_is_named_by_its_path(string json, string path)
    {
        var error = Assert.Throws<InputException>(() => Text.Format(json));
        Assert.Equal((MeasurementError.BadFormat, path), (error.Code, error.Place.Path));
        Assert.StartsWith(path, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Everything_wrong_in_a_description_of_a_larger_document_is_named()
    {
        var document = JsonInput.Read(
            """
            {
              "format": { "unti": "mm",
                "delimiter": "#" }
            }
            """u8,
            "job.json");
        var problems = new List<Refusal>();
        Assert.Null(MeasurementFormat.Read(document["format"], problems));
        Assert.Equal(
            [
                "line 2, column 15, $.format.unti: the key \"unti\" is not known here; did you mean \"unit\"?",
                "line 3, column 18, $.format.delimiter: found the text \"#\"; expected one of \",\", \";\", \"\t\", \"|\" or \" \".",
            ],
            problems.Select(p => p.ToString()));
        Assert.All(problems, p => Assert.Equal(MeasurementError.BadFormat, p.Code));
    }

    [Fact]
    public void Every_encoding_can_be_described() => Assert.All(
        MeasurementFormat.EncodingNames, n => Assert.Equal(n, Text.Format($$"""{ "encoding": "{{n}}" }""").Encoding));

    [Fact]
    public void Column_positions_count_from_one() => Assert.Throws<ArgumentOutOfRangeException>(() => ColumnSelector.At(0));
}
