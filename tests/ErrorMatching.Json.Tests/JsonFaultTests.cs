using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Json.Tests;

/// <summary>What a person wrote that is no JSON is named as what it is, where it begins.</summary>
public sealed class JsonFaultTests
{
    [Theory]
    [InlineData("{ \"a\": 0,02 }", 8, "the number 0,02 with a comma", "a decimal point (0.02)")]
    [InlineData("{ \"a\": [-0,05, 1] }", 9, "the number -0,05 with a comma", "a decimal point (-0.05)")]
    [InlineData("{ \"a\": 12,5, \"b\": 1 }", 8, "the number 12,5 with a comma", "a decimal point (12.5)")]
    [InlineData("{ \"a\": 1,, \"b\": 1 }", 10, "a second comma", "one comma, then a key")]
    [InlineData("[1,,2]", 4, "a second comma", "one comma, then a value")]
    [InlineData("[,1]", 2, "a comma without a value", "a value")]
    [InlineData("{, \"a\": 1}", 2, "a comma without a value", "a key")]
    [InlineData("{ \"a\": , \"b\": 1 }", 8, "a comma without a value", "a value")]
    [InlineData("{ 'a': 1 }", 3, "a single quotation mark", "a double")]
    [InlineData("{ \u201Ca\u201D: 1 }", 3, "the quotation mark \u201C", "a straight one")]
    [InlineData("{ a: 1 }", 3, "a", "a key in double quotes (\"a\")")]
    [InlineData("{ \"a\" = 1 }", 7, "an equals sign", "a colon")]
    [InlineData("{ \"a\" 1 }", 7, "1", "a colon")]
    [InlineData("{ \"a\": 1; \"b\": 2 }", 9, "a semicolon", "a comma")]
    [InlineData("{ \"a\": 1 \"b\": 2 }", 10, "without a comma in front", "a comma between")]
    [InlineData("{ \"a\": 6 mm }", 10, "mm behind a value", "a comma or a closing bracket")]
    [InlineData("{ \"a\": 06 }", 8, "the number 06", "a number such as")]
    [InlineData("{ \"a\": .6 }", 8, "the number .6", "a number such as")]
    [InlineData("{ \"a\": 6. }", 8, "the number 6.", "a number such as")]
    [InlineData("{ \"a\": +6 }", 8, "the number +6", "a number such as")]
    [InlineData("{ \"a\": True }", 8, "True", "true in small letters")]
    [InlineData("{ \"a\": yes }", 8, "yes", "a value")]
    [InlineData("{ \"a\": \"C:\\jobs\" }", 12, "\\j in a text", "\\\\ for a backslash")]
    [InlineData("{ \"a\": \"x", 8, "a text that does not end", "a closing quotation mark")]
    [InlineData("{ \"a\": \"x\n }", 8, "a text that does not end", "a closing quotation mark")]
    [InlineData("{ \"a\": [1, 2 }", 14, "}", "] for the [ in line 1")]
    [InlineData("{ \"a\": 1", 9, "the end of the file", "} for the { in line 1")]
    [InlineData("{} }", 4, "} behind the document", "one JSON value alone")]
    [InlineData("// note 0,5\n{ \"a\": 1,, }", 10, "a second comma", "one comma", 2)]
    public void A_slip_is_named_in_plain_words(string text, int column, string found, string expected, int line = 1)
    {
        var refusal = Assert.Single(
            Assert.Throws<InputException>(() => JsonInput.Read(Encoding.UTF8.GetBytes(text), "job.json")).Refusals);
        Assert.Equal(("not-json", line, column), (refusal.Code, refusal.Place.Line, refusal.Place.Column));
        Assert.Contains(found, refusal.Found, StringComparison.Ordinal);
        Assert.Contains(expected, refusal.Expected, StringComparison.Ordinal);
    }

    // Whatever is cut off, doubled or replaced, the words are ours and the place is in the file.
    [Fact]
    public void No_slip_is_told_in_the_words_of_the_library()
    {
        const string Good = "{ \"name\": \"L1\", // a note\n  \"limits\": [-0.05, 0.05], \"on\": true, \"of\": { \"x\": 1e-3 } }";
        var told = 0;
        for (var at = 0; at < Good.Length; at++)
        {
            foreach (var text in new[] { Good[..at], Good[..at] + Good[(at + 1)..], Good[..at] + "," + Good[at..],
                Good[..at] + "'" + Good[at..] })
            {
                try
                {
                    JsonInput.Read(Encoding.UTF8.GetBytes(text), "job.json");
                }
                catch (InputException e) when (e.Code == "not-json")
                {
                    told++;
                    Assert.DoesNotContain("invalid", e.Message, StringComparison.OrdinalIgnoreCase);
                    Assert.DoesNotContain("Expected", e.Message, StringComparison.Ordinal);
                    Assert.InRange(e.Refusals[0].Place.Line!.Value, 1, 2);
                }
                catch (InputException)
                {
                    // A duplicate key or an empty document.
                }
            }
        }

        Assert.True(told > 100, $"{told}");
    }
}
