using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class NoMeasurementTests
{
    private const string IgesStart = "cover                                                                   S      1\n";

    [Theory]
    [InlineData("ISO-10303-21;\nHEADER;\n", "a STEP file")]
    [InlineData(IgesStart, "an IGES file")]
    [InlineData("solid cover\n facet normal 0 0 1\n", "a mesh of triangles")]
    [InlineData("{\n  \"kind\": \"mating\"\n}\n", "a JSON document")]
    [InlineData("%\nO1000(COVER)\nN10 G90 G54\n", "an NC program")]
    [InlineData("; COVER\nG90 G54\n", "an NC program")]
    [InlineData("N10 G17\nN20 G1 X5\n", "an NC program")]
    [InlineData("%PDF-1.7\n", "a PDF")]
    [InlineData("<!DOCTYPE html>\n<html>", "an HTML page")]
    [InlineData("<?xml version=\"1.0\"?>\n<Results/>", "an XML document that is not QIF")]
    public void A_file_of_something_else_is_named_with_what_to_do(string text, string found)
    {
        foreach (var format in (MeasurementFormat[])[MeasurementFormat.Points, MeasurementFormat.Recognized])
        {
            var error = Text.Refused(text, format);
            Assert.Equal((MeasurementError.NotAMeasurement, 1, 1), (error.Code, error.Place.Line, error.Place.Column));
            Assert.Contains(found, error.Refusals[0].Found, StringComparison.Ordinal);
        }

        Assert.NotEqual(
            MeasurementError.NotAMeasurement, Text.Refused(text, Text.Format("""{ "columns": { "label": "Nr" } }""")).Code);
    }

    [Fact]
    public void A_binary_mesh_is_recognized_by_its_length()
    {
        var mesh = new byte[84 + (3 * 50)];
        mesh[80] = 3;
        Assert.Equal(MeasurementError.NotAMeasurement, Refused(mesh).Code);
        Assert.Equal(MeasurementError.BinaryFile, Refused(mesh[1..]).Code);

        static InputException Refused(byte[] bytes) =>
            Assert.Throws<InputException>(() => MeasurementReader.Read(bytes, "cover.stl", MeasurementFormat.Points));
    }

    [Theory]
    [InlineData("N1,x_mm,y_mm\n", MeasurementError.MissingColumn)]
    [InlineData("solid,x_mm,y_mm\n", MeasurementError.MissingColumn)]
    [InlineData("% points\npoint,x_mm,y_mm\n", MeasurementError.LongRow)]
    public void A_table_is_a_table(string text, string code) => Assert.Equal(code, Text.Refused(text).Code);
}
