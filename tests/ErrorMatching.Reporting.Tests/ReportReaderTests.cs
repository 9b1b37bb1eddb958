using System.Text;
using System.Text.Json;

namespace ErrorMatching.Reporting.Tests;

public sealed class ReportReaderTests
{
    private const string Document = """
        { "schema": "s", "lists": [{ "verdict": { "code": "inner" } }], "verdict" : {"code":"within", "more": {"cut": false}},
          "other": "verdict", "none": null, "after": { "code": "ä\u0022" } }
        """;

    [Theory]
    [InlineData("verdict", "within")]
    [InlineData("after", "ä\"")]
    public void One_object_is_read_as_it_is_among_all(string name, string code)
    {
        var alone = ReportReader.ObjectOf(Encoding.UTF8.GetBytes(Document), name);
        Assert.Equal(code, alone?.Text("code"));
        Assert.Equal(code, ReportReader.Document(Encoding.UTF8.GetBytes(Document)).Object(name).Text("code"));
    }

    [Theory]
    [InlineData("code")]
    [InlineData("cut")]
    [InlineData("other")]
    [InlineData("none")]
    [InlineData("lists")]
    public void No_other_value_is_taken_for_it(string name) =>
        Assert.Null(ReportReader.ObjectOf(Encoding.UTF8.GetBytes(Document), name));

    [Theory]
    [InlineData("[]")]
    [InlineData("3")]
    [InlineData("{}")]
    public void A_document_without_it_has_none(string json) => Assert.Null(ReportReader.ObjectOf(Encoding.UTF8.GetBytes(json), "verdict"));

    [Fact]
    public void What_is_no_JSON_is_refused() =>
        Assert.ThrowsAny<JsonException>(() => ReportReader.ObjectOf("{\"a\": {"u8, "verdict"));
}
