using System.Text;
using System.Xml;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Json.Tests;

/// <summary>Documents that repeat one thing for ever.</summary>
public class ReadingCostTests
{
    private static readonly JsonSchema Schema = JsonSchema.Parse(
        """
        {
          "type": "object", "additionalProperties": false, "required": ["name"],
          "properties": {
            "name": { "type": "string", "pattern": "^[a-z]+[0-9]*$" },
            "kind": { "enum": ["one", "two"] },
            "list": { "type": "array", "items": { "type": "object", "properties": { "a": { "type": "number" } }, "additionalProperties": false } }
          }
        }
        """u8.ToArray(),
        "schema.json");

    [Fact]
    public void Documents() => ReadingCost.IsLinear(
        bytes =>
        {
            try
            {
                Assert.NotNull(Schema.Check(JsonInput.Read(bytes, "job.json")));
            }
            catch (InputException e)
            {
                Assert.InRange(e.Message.Length, 1, 20_000);
            }
        },
        ("{", "\"a§\":1,", "}"),
        ("{", "\"a\":1,", "}"),
        ("{", "\"nam\":1,\"kin\":2,", "}"),
        ("{\"list\":[", "{\"a\":1},", "]}"),
        ("{\"list\":[", "{\"b\":1},", "]}"),
        ("{\"list\":[", "1,", "]}"),
        ("{\"name\":\"", "a", "\"}"),
        ("{\"name\":\"a", "1", "\"}"),
        ("{\"name\":\"a", "1", "x\"}"),
        ("{\"name\":\"", "\\u0041", "\"}"),
        ("{\"kind\":\"", "o", "\"}"),
        ("{\"a\":", "1", "}"),
        ("{\"a\":1e", "1", "}"),
        ("", "[", ""),
        ("", "{\"a\":", ""),
        ("", "[[],", ""),
        ("", "\n", ""),
        ("", "/**/", ""),
        ("/*", "*", ""),
        ("", "// x\n", ""),
        ("", "//", ""),
        ("", ",", ""),
        ("", "\"", ""),
        ("", "\"\" ", ""),
        ("", "\uFEFF", ""),
        ("", "é", ""));

    [Fact]
    public void Xml_of_others() => ReadingCost.IsLinear(
        bytes =>
        {
            using var nodes = new XmlNodes(bytes);
            try
            {
                while (nodes.Read())
                {
                    Assert.NotNull(nodes.Xml.Name);
                }
            }
            catch (XmlException e)
            {
                Assert.True(e.LineNumber > 0);
            }
        },
        ("<a ", "a§='' ", "/>"),
        ("<a ", "xmlns:a§='u' ", "/>"),
        ("<a>", "<a>", ""),
        ("<a>", "<b/>", "</a>"),
        ("<a>", "<!-- -->", "</a>"),
        ("<a>", "&amp;", "</a>"));

    [Fact]
    public void A_tag_longer_than_any_program_writes_is_refused_with_its_place()
    {
        var text = new StringBuilder("<a>\n<b ");
        for (var i = 0; text.Length < 2 * XmlNodes.MostNodeBytes; i++)
        {
            text.Append('a').Append(i).Append("='' ");
        }

        using var nodes = new XmlNodes(Encoding.UTF8.GetBytes(text.Append("/>\n</a>").ToString()));
        Assert.True(nodes.Read());
        var error = Assert.Throws<XmlException>(() => nodes.Read());
        Assert.Contains("more than 262144 bytes", error.Message, StringComparison.Ordinal);
        Assert.True(error.LineNumber is 1 or 2);
    }

    [Fact]
    public void A_document_of_many_short_nodes_is_read_whole()
    {
        var text = new StringBuilder("<a>");
        while (text.Length < 4 * XmlNodes.MostNodeBytes)
        {
            text.Append("<b c='1'>x</b><!-- y -->");
        }

        var (count, tags) = (0, 0);
        using var nodes = new XmlNodes(Encoding.Unicode.GetPreamble().Concat(Encoding.Unicode.GetBytes(text.Append("</a>").ToString()))
            .ToArray());
        while (nodes.Read())
        {
            count++;
            tags += nodes.Xml.NodeType == XmlNodeType.Element ? 1 : 0;
        }

        Assert.Equal((4 * (tags - 1)) + 2, count);
        Assert.True(tags > 4 * XmlNodes.MostNodeBytes / 24);
    }
}
