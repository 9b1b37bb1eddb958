using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class GridReaderTests
{
    private const string Good = "i,j,x,y,z\n0,0,0,0,1\n1,0,5,0,2\n0,1,0,4,3\n1,1,5,4,4\n";

    [Fact]
    public void Lines_may_stand_in_any_order_with_other_columns_and_quotes()
    {
        var grid = Read("\ufeffnote,\"z_mm\",y,x,j,i\nlast,4,4,5,2,2\n\"a, \"\"b\"\"\",1,0,0,1,1\n\nc,\"2\",0,5,1,2\nd,3,4,0,2,1\n");
        Assert.True(grid.IsRectangular);
        Assert.Equal([new(1, 1, new(0, 0, 1)), new(2, 1, new(5, 0, 2)), new(1, 2, new(0, 4, 3)), new(2, 2, new(5, 4, 4))], grid.Points);
    }

    [Fact]
    public void Curves_may_have_different_numbers_of_points()
    {
        var grid = Read(Good + "2,1,9,4,5\n");
        Assert.Equal([2, 3], grid.Curves.Select(c => c.Count));
        Assert.False(grid.IsRectangular);
    }

    [Theory]
    [InlineData("i,j,x,y\n0,0,0,0\n", "missing-column", 1, 1)]
    [InlineData("i,j,x,y,z,Z_mm\n", "duplicate-column", 1, 6)]
    [InlineData("i,j,x,y,z\n", "no-points", 1, 1)]
    [InlineData(Good + "0,0,9,9,9\n", "duplicate-point", 6, 1)]
    [InlineData(Good + "1.5,0,9,9,9\n", "number-out-of-range", 6, 1)]
    [InlineData(Good + "2,-1,9,9,9\n", "number-out-of-range", 6, 2)]
    [InlineData(Good + "99999999999,1,9,9,9\n", "number-out-of-range", 6, 1)]
    [InlineData(Good + "2001,1,9,9,9\n", "number-out-of-range", 6, 1)]
    [InlineData(Good + "2,0,nan,9,9\n", "not-a-number", 6, 3)]
    [InlineData(Good + "2,0,9,inf,9\n", "infinite-number", 6, 4)]
    [InlineData(Good + "2,0,9,9,\n", "empty-cell", 6, 5)]
    [InlineData(Good + "2,0,9,9,2000000\n", "implausible-number", 6, 5)]
    [InlineData(Good + "2,0,9,9\n", "short-row", 6, 5)]
    [InlineData(Good + "3,0,9,9,9\n", "missing-point", 6, 1)]
    [InlineData(Good + "0,3,9,9,9\n", "missing-point", 6, 2)]
    [InlineData(Good + "1,2,9,9,9\n2,2,9,8,7\n", "missing-point", 6, 1)]
    [InlineData(Good + "0,2,9,9,9\n", "missing-point", 6, 1)]
    [InlineData("i,j,x,y,z\n0,0,0,0,1\n1,0,5,0,2\n", "missing-point", 2, 2)]
    [InlineData(Good + "2,0,5,0,2\n", "duplicate-point", 6, 3)]
    [InlineData("i,j,x,y,z\n0,0,0,0,\"1\n", "unclosed-quote", 2, 5)]
    public void What_is_no_grid_is_named_by_line_and_column(string text, string code, int line, int column)
    {
        var error = Assert.Throws<InputException>(() => Read(text));
        Assert.Equal((code, "grid.csv", line, column), (error.Code, error.File, error.Place.Line, error.Place.Column));
        Assert.StartsWith($"grid.csv, line {line}, column {column}: found ", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_missing_point_is_called_by_its_numbers()
        => Assert.Contains(
            "found no point i = 2 on the curve j = 0, but i = 3",
            Assert.Throws<InputException>(() => Read(Good + "3,0,9,9,9\n")).Message,
            StringComparison.Ordinal);

    [Fact]
    public void More_points_than_can_be_fitted_in_reasonable_time_are_refused()
    {
        var text = new StringBuilder("i,j,x,y,z\n");
        for (var k = 0; k <= GridReader.MaxPoints; k++)
        {
            text.Append("1,1,1,1,1\n");
        }

        var error = Assert.Throws<InputException>(() => Read(text.ToString()));
        Assert.Equal(("too-many-points", GridReader.MaxPoints + 2), (error.Code, error.Place.Line));
    }

    private static PointGrid Read(string text) => GridReader.Read(Encoding.UTF8.GetBytes(text), "grid.csv");
}
