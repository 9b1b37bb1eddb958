using System.Text;
using ErrorMatching.Refusals;

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
        var error = Assert.Throws<InputException>(() => Parse(text));
        Assert.Equal("shop/our-mill.json", error.File);
        Assert.All(error.Refusals, p => Assert.NotEqual(("", ""), (p.Found, p.Expected)));
        return $"{error.Refusals[0].Code} {error.Refusals[0].Place.Path} {error.Refusals[0].Place.Line}:{error.Refusals[0].Place.Column}";
    }
}
