using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class NumberTableTests
{
    [Fact]
    public void Digits_are_kept_as_written_and_other_columns_ignored()
    {
        var table = Read("name,Y_mm,x,y_um\n\"a\nb\",1.10,0.1234567890123456789012345,zz\n=x, 2e-3 ,+5,\n", "x", "y");
        Assert.Equal(["0.1234567890123456789012345", "+5"], table["x"]);
        Assert.Equal(["1.10", "2e-3"], table["y"]);
        Assert.Equal([2, 4], table.Lines);
        Assert.Equal((2, "data.csv"), (table.Count, table.File));
    }

    [Theory]
    [InlineData("x;y\r\n1.5;2\r\n")]
    [InlineData("x\ty\n1.5\t2")]
    [InlineData("\uFEFFy;note, if any;x\n2;a,b;1.5\n")]
    public void Cells_may_stand_between_semicolons_or_tabs(string text)
    {
        var table = Read(text, "x", "y");
        Assert.Equal(["1.5"], table["x"]);
        Assert.Equal(["2"], table["y"]);
    }

    [Fact]
    public void Numbers_have_no_unit_and_no_plausible_limit() => Assert.Equal(["1e300"], Read("x\n1e300\n", "x")["x"]);

    [Theory]
    [InlineData("x\n1\n", MeasurementError.MissingColumn, 1, 1)]
    [InlineData("1,2\n3,4\n", MeasurementError.MissingHeader, 1, 1)]
    [InlineData("x,y,x_mm\n1,2,3\n", MeasurementError.DuplicateColumn, 1, 3)]
    [InlineData("x,y\n", MeasurementError.NoPoints, 1, 1)]
    [InlineData("x,y\n1,2\n1,1e999\n", MeasurementError.NumberOutOfRange, 3, 2)]
    [InlineData("x,y\n1,NaN\n", MeasurementError.NotANumber, 2, 2)]
    [InlineData("x,y\n1\n", MeasurementError.ShortRow, 2, 2)]
    [InlineData("", MeasurementError.EmptyFile, 1, 1)]
    public void A_bad_table_is_named(string text, string code, int line, int column)
    {
        var error = Assert.Throws<InputException>(() => Read(text, "x", "y"));
        Assert.Equal((code, "data.csv", line, column), (error.Code, error.File, error.Place.Line, error.Place.Column));
    }

    [Fact]
    public void A_missing_file_is_named() => Assert.Equal(
        MeasurementError.FileUnreadable, Assert.Throws<InputException>(() => NumberTable.Read("none.csv", "x", "y")).Code);

    private static NumberTable Read(string text, params string[] columns) =>
        NumberTable.Read(Encoding.UTF8.GetBytes(text), "data.csv", columns);
}
