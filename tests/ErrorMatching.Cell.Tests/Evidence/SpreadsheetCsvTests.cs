using System.Text;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Cell.Tests;

public sealed class SpreadsheetCsvTests
{
    // OWASP, CSV Injection: =, +, -, @, tab, carriage return, and their full-width forms; ASVS 5.0 1.2.10 adds the null character.
    private const string Executed = "=+-@\t\r\0\uff1d\uff0b\uff0d\uff20";

    [Theory]
    [InlineData("=1+1", "'=1+1"), InlineData("@SUM(A1)", "'@SUM(A1)"), InlineData("+49 89", "'+49 89"), InlineData("-0.05 mm", "'-0.05 mm"),
        InlineData("  =1", "  '=1"), InlineData("\"=1", "\"'=1"), InlineData("\u00a0=1", "\u00a0'=1")]
    [InlineData("\u200b=1", "\u200b'=1"), InlineData("\uff1dcmd|' /C calc'!A0", "'\uff1dcmd|' /C calc'!A0"), InlineData("a;=1", "a;'=1"),
        InlineData("a;\"=1", "a;\"'=1"), InlineData("a\n=1", "a\n'=1"), InlineData("a\t=1", "a\t'=1")]
    [InlineData("\t=1", "'\t'=1"), InlineData("looks right", "looks right"), InlineData("1 - 2 = -1, as planned", "1 - 2 = -1, as planned"),
        InlineData("", ""), InlineData("a, -b", "a, -b")]
    public void What_begins_like_a_formula_is_text(string text, string safe) => Assert.Equal(safe, SpreadsheetCsv.Defused(text));

    [Fact]
    public void Rows_are_quoted_as_RFC_4180_says()
    {
        using var csv = new StringWriter();
        SpreadsheetCsv.Write(csv, "a", "b\"c", "d,e", "f\r\ng", "");
        Assert.Equal("\"a\",\"b\"\"c\",\"d,e\",\"f\r\ng\",\"\"\r\n", csv.ToString());
    }

    [Fact]
    public void No_cell_is_executed_whatever_the_separator_and_every_cell_comes_back()
    {
        var letters = Gen.Elements((Executed + "\"\"';,| \n\u2028\u00a0\uff02aZ0ä").ToCharArray());
        var cells = letters.ArrayOf().Select(c => new string(c)).ArrayOf();
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(3000), Prop.ForAll(cells.ToArbitrary(), row =>
        {
            if (row.Length == 0)
            {
                return;
            }

            using var writer = new StringWriter();
            SpreadsheetCsv.Write(writer, row);
            var csv = writer.ToString();

            // Read by RFC 4180, each cell is the text but for the apostrophes.
            var read = Cells(csv);
            Assert.Equal(row.Length, read.Count);
            for (var i = 0; i < row.Length; i++)
            {
                Assert.True(IsHarmless(read[i]), Escaped(read[i]));
                Assert.Equal(row[i].Replace("'", "", StringComparison.Ordinal), read[i].Replace("'", "", StringComparison.Ordinal));
            }

            // Split by a spreadsheet that has another separator and no mind for our quotes, no piece is executed either.
            Assert.All(csv.Split(';', '\t', '|', '\n', '\r'), piece => Assert.True(IsHarmless(piece), Escaped(piece)));
        }));
    }

    private static bool IsHarmless(string cell)
    {
        if (cell.Length > 0 && Executed.Contains(cell[0], StringComparison.Ordinal))
        {
            return false;
        }

        var start = cell.TrimStart(" \"\u00a0\uff02\u2028\n\r\t\0".ToCharArray());
        return start.Length == 0 || !Executed.Contains(start[0], StringComparison.Ordinal);
    }

    private static List<string> Cells(string row)
    {
        var cells = new List<string>();
        for (var at = 0; row[at] != '\r'; at += row[at] == ',' ? 1 : 0)
        {
            Assert.Equal('"', row[at++]);
            var cell = new StringBuilder();
            for (; row[at] != '"' || row[at + 1] == '"'; at++)
            {
                cell.Append(row[at]);
                at += row[at] == '"' ? 1 : 0;
            }

            at++;
            cells.Add(cell.ToString());
        }

        Assert.EndsWith("\r\n", row, StringComparison.Ordinal);
        return cells;
    }

    private static string Escaped(string text) =>
        string.Concat(text.Select(c => c is > ' ' and < '\x7f' ? c.ToString() : $"\\u{(int)c:x4}"));
}
