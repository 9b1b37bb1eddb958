using System.Text;
using ErrorMatching.Json;

namespace ErrorMatching.Nc.Tests;

/// <summary>Dialect files in text, as a shop writes them.</summary>
internal static class OwnDialect
{
    /// <summary>A dialect that continues Fanuc, with further members, each with a comma in front.</summary>
    public static NcDialect Of(string members, string like = "fanuc") =>
        Parse($$"""{ "name": "our-mill", "like": "{{like}}", "description": "Ours."{{members}} }""");

    /// <summary>The dialect in a text.</summary>
    public static NcDialect Parse(string text) => NcDialects.Parse(Encoding.UTF8.GetBytes(text), "shop/our-mill.json");

    /// <summary>The first thing that is wrong in a text: code, JSON path, line and column.</summary>
    public static string Problem(string text)
    {
        var error = Assert.Throws<JsonDocumentException>(() => Parse(text));
        Assert.Equal("shop/our-mill.json", error.File);
        Assert.All(error.Problems, p => Assert.NotEqual(("", ""), (p.Found, p.Expected)));
        return $"{error.Problems[0].Code} {error.Problems[0].Path} {error.Problems[0].Line}:{error.Problems[0].Column}";
    }
}
