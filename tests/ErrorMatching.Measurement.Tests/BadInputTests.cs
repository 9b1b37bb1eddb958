using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class BadInputTests
{
    private const string Header = "point,x_mm,y_mm\n";

    [Theory]
    [InlineData("NaN", MeasurementError.NotANumber)]
    [InlineData("-nan", MeasurementError.NotANumber)]
    [InlineData("nan(ind)", MeasurementError.NotANumber)]
    [InlineData("1.#QNAN", MeasurementError.NotANumber)]
    [InlineData("-1.#IND", MeasurementError.NotANumber)]
    [InlineData("inf", MeasurementError.InfiniteNumber)]
    [InlineData("-Infinity", MeasurementError.InfiniteNumber)]
    [InlineData("∞", MeasurementError.InfiniteNumber)]
    [InlineData("1.#INF", MeasurementError.InfiniteNumber)]
    [InlineData("abc", MeasurementError.TextForNumber)]
    [InlineData("12.5mm", MeasurementError.TextForNumber)]
    [InlineData("---", MeasurementError.TextForNumber)]
    [InlineData("-", MeasurementError.TextForNumber)]
    [InlineData(".", MeasurementError.TextForNumber)]
    [InlineData("1e", MeasurementError.TextForNumber)]
    [InlineData("1e+", MeasurementError.TextForNumber)]
    [InlineData("1.2.3", MeasurementError.TextForNumber)]
    [InlineData("0x10", MeasurementError.TextForNumber)]
    [InlineData("１２", MeasurementError.TextForNumber)]
    [InlineData("−5", MeasurementError.TextForNumber)]
    [InlineData("#REF!", MeasurementError.TextForNumber)]
    [InlineData("", MeasurementError.EmptyCell)]
    [InlineData("   ", MeasurementError.EmptyCell)]
    [InlineData("=1+1", MeasurementError.Formula)]
    [InlineData("+A1", MeasurementError.Formula)]
    [InlineData("-A1*2", MeasurementError.Formula)]
    [InlineData("@SUM(A1)", MeasurementError.Formula)]
    [InlineData("\"1,234.5\"", MeasurementError.ThousandsSeparator)]
    [InlineData("\"1,234,567\"", MeasurementError.ThousandsSeparator)]
    [InlineData("1 234.5", MeasurementError.ThousandsSeparator)]
    [InlineData("1\u00a0234", MeasurementError.ThousandsSeparator)]
    [InlineData("1'234.5", MeasurementError.ThousandsSeparator)]
    [InlineData("\"1.234,5\"", MeasurementError.ThousandsSeparator)]
    [InlineData("1.234.567", MeasurementError.ThousandsSeparator)]
    [InlineData("\"32,067\"", MeasurementError.DecimalComma)]
    [InlineData("\"-5,5\"", MeasurementError.DecimalComma)]
    [InlineData("1e999", MeasurementError.NumberOutOfRange)]
    [InlineData("1e-999", MeasurementError.NumberOutOfRange)]
    [InlineData("1e99999999999", MeasurementError.NumberOutOfRange)]
    [InlineData("1000000.001", MeasurementError.ImplausibleNumber)]
    [InlineData("-32067000", MeasurementError.ImplausibleNumber)]
    public void A_cell_that_is_no_coordinate_is_named(string cell, string code)
    {
        var error = Text.Refused(Header + "A,1,2\nB,3," + cell + "\n");
        Assert.Equal((code, "part.csv", 3, 3), (error.Code, error.File, error.Place.Line, error.Place.Column));
        Assert.NotEmpty(error.Refusals[0].Found);
        Assert.NotEmpty(error.Refusals[0].Expected);
    }

    [Fact]
    public void A_line_of_too_many_cells_is_refused_where_the_first_one_too_many_is()
    {
        Assert.Equal(1, Text.Read(Header + "A,1,2" + new string(',', 997) + "\n")["A"].Position.X);
        var error = Text.Refused(Header + "A,1,2" + new string(',', 998) + "\n");
        Assert.Equal((MeasurementError.TooManyCells, 2, 1001), (error.Code, error.Place.Line, error.Place.Column));
        Assert.Contains("1001 cells", error.Refusals[0].Found, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(",", 1)]
    [InlineData("a\n", 1_000_001)]
    [InlineData(",,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,\n", 81_633)]
    public void A_file_of_nothing_but_cells_costs_little_more_than_its_text(string part, int line)
    {
        var text = string.Concat(Enumerable.Repeat(part, 16 * 1024 * 1024 / part.Length));
        var before = GC.GetAllocatedBytesForCurrentThread();
        var error = Text.Refused(text);
        Assert.Equal((MeasurementError.TooManyCells, line), (error.Code, error.Place.Line));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 100 * 1024 * 1024);
    }

    [Fact]
    public void A_kilometer_is_the_limit_of_a_coordinate() => Assert.Equal(1e6, Text.Read(Header + "A,1000000,2\n")["A"].Position.X);

    [Theory]
    [InlineData("12.5", MeasurementError.DecimalPoint)]
    [InlineData("12.345", MeasurementError.DecimalPoint)]
    [InlineData("1.234,5", MeasurementError.ThousandsSeparator)]
    [InlineData("1,234.5", MeasurementError.ThousandsSeparator)]
    public void A_decimal_point_where_the_format_says_comma_is_named(string cell, string code)
    {
        var error = Text.Refused("point;x_mm;y_mm\nA;1;" + cell + "\n", Text.Format("""{ "delimiter": ";", "decimalComma": true }"""));
        Assert.Equal((code, 2, 3), (error.Code, error.Place.Line, error.Place.Column));
    }

    [Theory]
    [InlineData("", MeasurementError.EmptyFile, 1, 1)]
    [InlineData(" \n\n\t\n", MeasurementError.EmptyFile, 1, 1)]
    [InlineData("point,x_mm,y_mm", MeasurementError.NoPoints, 1, 1)]
    [InlineData("1,2,3\n4,5,6\n", MeasurementError.MissingHeader, 1, 1)]
    [InlineData("P1,2.5,3.5\n", MeasurementError.MissingHeader, 1, 1)]
    [InlineData("point,x_mm\nA,1\n", MeasurementError.MissingColumn, 1, 1)]
    [InlineData("\npoint;x_mm;y_mm\nA;1;2\n", MeasurementError.MissingColumn, 2, 1)]
    [InlineData("point,x_mm,y_mm,X_MM\nA,1,2,3\n", MeasurementError.DuplicateColumn, 1, 4)]
    [InlineData("point,x_mm,y_mm\nA,1\n", MeasurementError.ShortRow, 2, 3)]
    [InlineData("point,x_mm,y_mm,note\nA,1,2\n", MeasurementError.ShortRow, 2, 4)]
    [InlineData("point,x_mm,y_mm\nA,1,2,5,3\n", MeasurementError.LongRow, 2, 4)]
    [InlineData("point,x_mm,y_mm\nA,1,2\n\nB,1,2\nA,3,4\n", MeasurementError.DuplicatePoint, 5, 1)]
    [InlineData("point,x_mm,y_mm\n,1,2\n", MeasurementError.EmptyCell, 2, 1)]
    [InlineData("point,x_mm,y_mm\n,,\n", MeasurementError.EmptyCell, 2, 1)]
    [InlineData("point,x_mm,y_mm\n=A1,1,2\n", MeasurementError.Formula, 2, 1)]
    [InlineData("point,x_mm,y_mm\nA,1,\"2\nB,3,4\n", MeasurementError.UnclosedQuote, 2, 3)]
    [InlineData("point,x_mm,y_mm\n\"A\nB\",1,\"2", MeasurementError.UnclosedQuote, 3, 3)]
    [InlineData("point,x_mm,y_mm\nA,1\"5,2\n", MeasurementError.BadQuote, 2, 2)]
    [InlineData("point,x_mm,y_mm\nA,\"1\"5,2\n", MeasurementError.BadQuote, 2, 2)]
    [InlineData("point,x_mm,y_mm\nA,1,2\nB,3,\0\n", MeasurementError.BinaryFile, 3, 3)]
    [InlineData("point,x_mm,y_mm\nA,1,2\nB\u0007,3,4\n", MeasurementError.BinaryFile, 3, 1)]
    public void A_file_that_does_not_follow_the_format_is_named(string text, string code, int line, int column)
    {
        var error = Text.Refused(text);
        Assert.Equal((code, "part.csv", line, column), (error.Code, error.File, error.Place.Line, error.Place.Column));
    }

    [Fact]
    public void Trailing_delimiters_are_no_long_row() => Assert.Single(Text.Read(Header + "A,1,2,, \n").Points);

    [Fact]
    public void A_wrong_delimiter_is_guessed_in_the_message_only() =>
        Assert.Contains("\";\"", Text.Refused("point;x_mm;y_mm\nA;1;2\n").Message, StringComparison.Ordinal);

    [Fact]
    public void Too_many_bytes_are_refused_before_they_are_read()
    {
        var error = Text.Refused(Header + "A,1,2\n", Text.Format("""{ "maxBytes": 21 }"""));
        Assert.Equal((MeasurementError.FileTooLarge, "part.csv", 1, 1), (error.Code, error.File, error.Place.Line, error.Place.Column));
        Assert.Single(Text.Read(Header + "A,1,2\n", Text.Format("""{ "maxBytes": 22 }""")).Points);
    }

    // A file of 300 MB that has no content on the disk.
    [Fact]
    public void A_file_that_is_too_large_is_not_read()
    {
        var path = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
        try
        {
            using (var file = File.Create(path))
            {
                file.SetLength(300 << 20);
            }

            var before = GC.GetAllocatedBytesForCurrentThread();
            var error = Assert.Throws<InputException>(() => MeasurementReader.Read(path, MeasurementFormat.Points));
            Assert.Equal(MeasurementError.FileTooLarge, error.Code);
            Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1 << 20);
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Fact]
    public void Too_many_points_are_refused_at_the_first_above_the_limit()
    {
        var error = Text.Refused(Header + "A,1,2\nB,1,2\nC,1,2\n", Text.Format("""{ "maxPoints": 2 }"""));
        Assert.Equal((MeasurementError.TooManyPoints, 4, 1), (error.Code, error.Place.Line, error.Place.Column));
    }

    [Fact]
    public void A_file_of_a_spreadsheet_is_a_binary_file() =>
        Assert.Equal(
            MeasurementError.BinaryFile,
            Assert.Throws<InputException>(() => MeasurementReader.Read(
                "PK\u0003\u0004\u0014\0\u0006\0"u8.ToArray(), "a.xlsx", MeasurementFormat.Points)).Code);

    [Theory]
    [InlineData("no-such-folder/part.csv")]
    [InlineData("")]
    [InlineData(".")]
    [InlineData("a\0b")]
    public void A_file_that_cannot_be_opened_is_named(string path)
    {
        var error = Assert.Throws<InputException>(() => MeasurementReader.Read(path, MeasurementFormat.Points));
        Assert.Equal((MeasurementError.FileUnreadable, path), (error.Code, error.File));
    }

    [Fact]
    public void A_file_on_disk_is_read_like_its_bytes()
    {
        var path = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
        try
        {
            var lines = string.Concat(Enumerable.Range(1, 2000).Select(i => FormattableString.Invariant($"{i},{i},{i}\n")));
            File.WriteAllText(path, Header + lines);
            var (file, bytes) = (
                MeasurementReader.Read(path, MeasurementFormat.Points),
                MeasurementReader.Read(Encoding.UTF8.GetBytes(Header + lines), path, MeasurementFormat.Points));
            Assert.Equal((bytes.Sha256, bytes.File), (file.Sha256, file.File));
            Assert.Equal(bytes.Points, file.Points);
            Assert.Equal(
                MeasurementError.FileTooLarge,
                Assert.Throws<InputException>(() => MeasurementReader.Read(
                    path, MeasurementFormat.Points with { MaxBytes = 100 })).Code);
        }
        finally
        {
            File.Delete(path);
        }
    }
}
