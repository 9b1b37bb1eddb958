using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class EncodingTests
{
    private const string Table = "point,x_mm,y_mm\nMaß,1,2\n";

    [Fact]
    public void A_byte_order_mark_is_no_part_of_the_header() => Assert.Equal(2, Text.Read("\uFEFF" + Table)["Maß"].Line);

    [Fact]
    public void Each_encoding_reads_what_was_written_in_it()
    {
        Assert.Equal("Maß", Label(Encoding.Latin1.GetBytes(Table), "latin-1"));
        Assert.Equal("Maß", Label(Encoding.Unicode.GetBytes(Table), "utf-16"));
        Assert.Equal("Maß", Label([0xFF, 0xFE, .. Encoding.Unicode.GetBytes(Table)], "utf-16"));
        Assert.Equal("Maß", Label([0xFE, 0xFF, .. Encoding.BigEndianUnicode.GetBytes(Table)], "utf-16"));
        Assert.Equal("Maß", Label(Encoding.BigEndianUnicode.GetBytes(Table), "utf-16be"));
        // 0xC249 is the first character of "point" in Big5; the second byte of 0xA55C is a backslash in ASCII.
        Assert.Equal("點功", Label([.. "point,x_mm,y_mm\n"u8, 0xC2, 0x49, 0xA5, 0x5C, .. ",1,2"u8], "big5"));
        // 0x80 is the euro sign in Windows-1252; 0xB5E3 and 0x935F are the first character of "point" in GB 18030 and Shift-JIS.
        Assert.Equal("€", Label([.. "point,x_mm,y_mm\n"u8, 0x80, .. ",1,2"u8], "windows-1252"));
        Assert.Equal("点", Label([.. "point,x_mm,y_mm\n"u8, 0xB5, 0xE3, .. ",1,2"u8], "gb18030"));
        Assert.Equal("点", Label([.. "point,x_mm,y_mm\n"u8, 0x93, 0x5F, .. ",1,2"u8], "shift-jis"));
    }

    // PC-DMIS writes in the code page of its Windows. Without a hint, the name of the part would be read as windows-1252.
    [Fact]
    public void The_jobs_encoding_is_that_of_reports_and_logs_too()
    {
        byte[] name = [.. "PART NAME : "u8, 0xA5, 0x5C, .. "\n"u8];
        byte[] report = [.. name, .. OwnFormats.Bytes(OwnFormats.All["part.txt"])];
        Assert.Equal("功", Name(MeasurementReader.Read(report, "part.txt", Text.Format("""{ "encoding": "big5" }"""))));
        Assert.Equal("¥\\", Name(MeasurementReader.Read(report, "part.txt", MeasurementFormat.Points)));

        static string Name(MeasurementFile file) => file.HeaderFields.First(f => f.Name == "PART NAME").Value;
    }

    [Fact]
    public void A_byte_that_is_no_text_is_named_with_its_place()
    {
        var error = Assert.Throws<InputException>(() => Label([.. "point,x_mm,y_mm\nA,1,2\nB\u00e9,"u8, 0xE9, .. ",4\n"u8], "utf-8"));
        Assert.Equal((MeasurementError.InvalidEncoding, 3, 2), (error.Code, error.Place.Line, error.Place.Column));
        Assert.Contains("0xE9", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_character_cut_off_at_the_end_is_named()
    {
        var error = Assert.Throws<InputException>(() => Label([.. "point,x_mm,y_mm\nA,1,2"u8, 0xE4, 0xB8], "utf-8"));
        Assert.Equal((MeasurementError.InvalidEncoding, 2, 3), (error.Code, error.Place.Line, error.Place.Column));
        Assert.Equal(
            MeasurementError.InvalidEncoding,
            Assert.Throws<InputException>(() => Label(Encoding.Unicode.GetBytes(Table)[..^1], "utf-16")).Code);
    }

    [Fact]
    public void Another_encodings_byte_order_mark_is_named()
    {
        var error = Assert.Throws<InputException>(() => Label([0xFF, 0xFE, .. Encoding.Unicode.GetBytes(Table)], "utf-8"));
        Assert.Equal((MeasurementError.InvalidEncoding, 1, 1), (error.Code, error.Place.Line, error.Place.Column));
        Assert.Contains("utf-16", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_nul_in_utf_16_is_binary() => Assert.Equal(
        MeasurementError.BinaryFile,
        Assert.Throws<InputException>(() => Label(Encoding.Unicode.GetBytes("point,\0"), "utf-16")).Code);

    private static string Label(byte[] bytes, string encoding) =>
        MeasurementReader.Read(bytes, "part.csv", Text.Format($$"""{ "encoding": "{{encoding}}" }""")).Points[0].Label;
}
