using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement.Tests;

public class RecognizedTableTests
{
    [Theory]
    [InlineData("point,x,y,z\nA,1,2,3\n")]
    [InlineData("LABEL;x_mm;y_mm;z_mm\nA;1;2;3\n")]
    [InlineData("\n\"point\"\tz\ty\tx\nA\t3\t2\t1\n")]
    [InlineData("point|x|y|z_mm|note\nA|1|2|3|, ; \n")]
    [InlineData("  point    x     y    z \r\n  A   1.0   2.0\t3.0  \r\n")]
    [InlineData("feature;item;nominal;actual\nA;X;1.5;1\nA;Y;2;2\nA;Z;3;3\n")]
    [InlineData("feature,item,nominal,actual,deviation\nA,X,1.5,1,-0.5\nA,Y,2,2,0\nA,Z,3,3,0\n")]
    public void The_header_shows_delimiter_and_columns(string text) =>
        Assert.Equal(new Point3(1, 2, 3), Assert.Single(Text.Read(text, MeasurementFormat.Recognized).Points).Position);

    [Theory]
    [InlineData(true, 0, '\0', "point;x;y;z\nA;1,5;2;3\n")]
    [InlineData(true, 0, '\0', "point\tx_mm\ty_mm\tz_mm\nA\t1,5\t2\t3\n")]
    [InlineData(false, 2, '\0', "Shop: a;b\n\ni;j;x;y;z\n0;1;1.5;2;3\n")]
    [InlineData(false, 0, ',', "point,x,y,z,a;b\nA,1.5,2,3,;\n")]
    public void What_a_description_states_holds_and_the_header_shows_the_rest(bool comma, int skip, char delimiter, string text) =>
        Assert.Equal(
            new Point3(1.5, 2, 3),
            Assert.Single(Text.Read(
                text,
                MeasurementFormat.Recognized with { DecimalComma = comma, SkipLines = skip, Delimiter = delimiter }).Points).Position);

    [Fact]
    public void Blanks_between_quotation_marks_stay()
    {
        var format = Text.Format("""{ "delimiter": " " }""");
        var file = Text.Read("point x_mm  y_mm note\n\"P  1\" 1 2 \"a  b\"\n", format);
        Assert.Equal(1, file["P  1"].Position.X);
        Assert.Equal(["a  b"], file.ColumnTexts("note"));
        var error = Text.Refused("point x_mm y_mm\n1 2\n", format);
        Assert.Equal((MeasurementError.ShortRow, 2, 3), (error.Code, error.Place.Line, error.Place.Column));
    }

    [Fact]
    public void A_job_may_name_it() => Assert.Same(MeasurementFormat.Recognized, Text.Format("\"recognized\""));

    [Fact]
    public void A_grid_names_its_points_by_their_places()
    {
        var file = Text.Read("j;i;x;y;z\n0;1;1;2;3\n-1;1;4;5;6\n", MeasurementFormat.Recognized);
        Assert.Equal(["1,0", "1,-1"], file.Points.Select(p => p.Label));
        Assert.Equal((new Point3(4, 5, 6), 3), (file["1,-1"].Position, file["1,-1"].Line));
        Assert.Equal("1,0", Assert.Single(Text.Read("i,j,x_mm,y_mm,z_mm\n1,0,1,2,3\n", MeasurementFormat.Grid).Points).Label);
    }

    [Theory]
    [InlineData("i,j,x,y,z\n1,0,1,2,3\n1,0,1,2,3\n", MeasurementError.DuplicatePoint, 3, 1)]
    [InlineData("i,j,x,y,z\n1,,1,2,3\n", MeasurementError.EmptyCell, 2, 2)]
    [InlineData("i,j,x,y,z\n1,9999999999,1,2,3\n", MeasurementError.TextForNumber, 2, 2)]
    [InlineData("i,j,x,y\n1,0,1,2\n", MeasurementError.MissingColumn, 1, 1)]
    [InlineData("point;x;y\nA;1;2,5\n", MeasurementError.DecimalComma, 2, 3)]
    [InlineData("feature,item,nominal,actual,deviation\nA,X,1.5,1,0.5\n", MeasurementError.InconsistentDeviation, 2, 5)]
    public void A_wrong_table_is_named(string text, string code, int line, int column)
    {
        var error = Text.Refused(text, MeasurementFormat.Recognized);
        Assert.Equal((code, line, column), (error.Code, error.Place.Line, error.Place.Column));
    }

    [Fact]
    public void The_file_of_a_surface_may_be_longer_than_that_of_a_part() =>
        Assert.True(
            MeasurementFormat.Recognized.MaxBytes > MeasurementFormat.Points.MaxBytes
            && MeasurementFormat.Recognized.MaxPoints > MeasurementFormat.Points.MaxPoints);
}
