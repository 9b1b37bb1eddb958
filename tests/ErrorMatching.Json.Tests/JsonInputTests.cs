using System.Text;
using ErrorMatching.Refusals;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Json.Tests;

public sealed class JsonInputTests
{
    [Fact]
    public void Values_know_their_path_line_and_column()
    {
        var root = Read("{\n  \"features\": [\n    { \"name\": \"L1\" },\n    { \"ß\": 1, \"kind\": null }\n  ]\n}");

        var second = root["features"].Items[1];
        Assert.Equal("$.features[1].kind", second["kind"].Path);
        Assert.Equal(new JsonPlace(4, 23), second["kind"].Place);
        Assert.Equal("$.features[1]['ß']", second["ß"].Path);
        Assert.Equal(new JsonPlace(4, 7), second.Members[0].Place);
        Assert.Equal("$['it\\'s'].a_1", Read("{\"it's\": {\"a_1\": 1}}")["it's"]["a_1"].Path);
    }

    [Theory]
    [InlineData("")]
    [InlineData("\uFEFF")]
    public void Values_know_their_bytes(string mark)
    {
        var text = mark + "// ß\n{ \"ä\": [1, \"é\\u00e9\", ], \"b\": { \"c\": true } /* d */ }\n";
        var (root, bytes) = (Read(text), Encoding.UTF8.GetBytes(text));

        Assert.Equal(
            ["[1, \"é\\u00e9\", ]", "\"é\\u00e9\"", "1", "{ \"c\": true }", "true", text[(mark.Length + 5)..^1]],
            new[]
            {
                root["ä"],
                root["ä"].Items[1],
                root["ä"].Items[0],
                root["b"],
                root["b"]["c"],
                root
            }.Select(i => Encoding.UTF8.GetString(bytes[i.Bytes])));
    }

    [Fact(Timeout = 20_000)]
    public async Task A_long_line_is_counted_once_and_not_for_each_of_its_values()
    {
        var text = "{ \"ß\": [" + string.Join(",", Enumerable.Repeat("\"é\"", 400_000)) + ",7] }";
        var root = await Task.Run(() => Read(text), TestContext.Current.CancellationToken);

        // Behind 8 characters come 400,000 texts, each with its quotation marks and a comma.
        Assert.Equal(new JsonPlace(1, 9 + (4 * 400_000)), root["ß"].Items[^1].Place);
    }

    [Fact]
    public void Comments_and_trailing_commas_and_a_byte_order_mark_are_allowed()
    {
        var root = Read("\uFEFF// job\n{ \"a\": [1, 2,], /* b */ \"b\": true, }\n// end");

        Assert.Equal("{\"a\":[1,2],\"b\":true}", root.ToJson());
        Assert.Equal(new JsonPlace(2, 1), root.Place);
    }

    [Fact]
    public void Every_kind_of_value_is_read()
    {
        var root = Read("[null, true, false, -1.50e1, \"a\\u00e9\\n\", [], {}]");

        Assert.Equal(
            [
                JsonItemKind.Null, JsonItemKind.Boolean, JsonItemKind.Boolean, JsonItemKind.Number, JsonItemKind.Text, JsonItemKind.List,
                JsonItemKind.Object],
            root.Items.Select(i => i.Kind));
        Assert.True(root.Items[1].Flag);
        Assert.False(root.Items[2].Flag);
        Assert.Equal(-15, root.Items[3].Number);
        Assert.Equal("-1.50e1", root.Items[3].Text);
        Assert.Equal("aé\n", root.Items[4].Text);
        Assert.Null(root.Items[6].Find("x"));
        Assert.Throws<KeyNotFoundException>(() => root.Items[6]["x"]);
        Assert.Equal("[null,true,false,-1.50e1,\"a\\u00E9\\n\",[],{}]", root.ToJson());
    }

    [Theory]
    [InlineData("", "empty-document", 1, 1)]
    [InlineData("  \n", "empty-document", 1, 1)]
    [InlineData("// nothing", "not-json", 1, 11)]
    [InlineData("{\n  \"a\": 1\n  \"b\": 2\n}", "not-json", 3, 3)]
    [InlineData("{ \"a\": NaN }", "not-json", 1, 8)]
    [InlineData("[1, 2", "not-json", 1, 6)]
    [InlineData("{} {}", "not-json", 1, 4)]
    [InlineData("[1e999]", "number-out-of-range", 1, 2)]
    [InlineData("{\"a\": 1,\n \"a\": 2}", "duplicate-key", 2, 2)]
    [InlineData("[\"\\ud800\"]", "not-utf8", 1, 2)]
    public void Text_that_is_no_document_is_refused_by_place(string text, string code, int line, int column)
    {
        var problem = Assert.Single(Refused(Encoding.UTF8.GetBytes(text)));

        Assert.Equal(code, problem.Code);
        Assert.Equal((line, column), (problem.Place.Line, problem.Place.Column));
        Assert.DoesNotContain("LineNumber", problem.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void All_duplicate_keys_are_reported_with_their_paths() =>
        Assert.Equal(["$.a", "$.b.c"], Refused("{\"a\": 1, \"a\": 2, \"b\": {\"c\": 1, \"c\": 1}}"u8).Select(p => p.Place.Path));

    [Fact]
    public void Bytes_that_are_not_utf8_are_refused_by_place()
    {
        var problem = Assert.Single(Refused([.. "{\n \"é"u8, 0xFC, .. "\": 1}"u8]));

        Assert.Equal(("not-utf8", 2, 4, "the byte 0xFC"), (problem.Code, problem.Place.Line, problem.Place.Column, problem.Found));
    }

    [Fact]
    public void Documents_over_the_limits_are_refused()
    {
        var limits = new JsonLimits(8, 3);

        Assert.Equal("too-big", Assert.Single(Refused("123456789"u8, limits)).Code);
        Assert.Equal(12345678, JsonInput.Read("12345678"u8, "x", limits).Number);
        Assert.Equal("[[[]]]", JsonInput.Read("[[[]]]"u8, "x", limits).ToJson());
        var problem = Assert.Single(Refused("[[[{}]]]"u8, limits));
        Assert.Equal(("too-deep", "$[0][0][0]", 4), (problem.Code, problem.Place.Path, problem.Place.Column));
    }

    [Fact]
    public void A_document_of_too_many_values_is_refused_at_the_first_one_too_many()
    {
        var limits = new JsonLimits(100, 3, 4);

        Assert.Equal(3, JsonInput.Read("[1,2,3]"u8, "x", limits).Items.Count);
        var problem = Assert.Single(Refused("[1,2,\n3,4]"u8, limits));
        Assert.Equal(("too-many-values", "$", 2, 3), (problem.Code, problem.Place.Path, problem.Place.Line, problem.Place.Column));
    }

    [Fact]
    public void After_a_hundred_problems_a_last_one_says_that_there_are_more()
    {
        var keys = string.Join(',', Enumerable.Repeat("\"a\":1", 101));
        Assert.Equal(100, Refused(Encoding.UTF8.GetBytes($"{{{keys}}}")).Count);
        var problems = Refused(Encoding.UTF8.GetBytes($"{{{keys},\"a\":1,\"a\":1}}"));
        Assert.Equal(101, problems.Count);
        Assert.Equal(("too-many-problems", "$.a"), (problems[^1].Code, problems[^1].Place.Path));
        Assert.All(problems.SkipLast(1), p => Assert.Equal("duplicate-key", p.Code));
    }

    [Fact]
    public void A_file_is_read_no_further_than_its_limit()
    {
        var path = Path.GetTempFileName();
        try
        {
            File.WriteAllText(path, "[1, 2]");
            Assert.Equal(2, JsonInput.Read(JsonInput.Load(path), path).Items.Count);
            Assert.Equal(6, JsonInput.Load(path, new(5, 3)).Length);
            Assert.Equal("too-big", Assert.Single(Refused(JsonInput.Load(path, new(5, 3)), new(5, 3))).Code);
            File.WriteAllText(path, "[1, 2, 3, 4]");
            Assert.Equal(6, JsonInput.Load(path, new(5, 3)).Length);
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Fact]
    public void Reading_the_strict_form_again_gives_the_same_document()
    {
        var text = ArbMap.Default.ArbFor<NonNull<string>>();
        Check.QuickThrowOnFailure(Prop.ForAll(text, text, ArbMap.Default.ArbFor<NormalFloat>(), (key, value, number) =>
        {
            // Half a surrogate pair is no text, and FsCheck makes some.
            if (!IsText(key.Get) || !IsText(value.Get))
            {
                return true;
            }

            var json = System.Text.Json.JsonSerializer.Serialize(
                new Dictionary<string, object?> { [key.Get] = new object?[] { value.Get, number.Get, null } });
            var once = JsonInput.Read(Encoding.UTF8.GetBytes(json), "x");
            var twice = JsonInput.Read(Encoding.UTF8.GetBytes(once.ToJson()), "x");
            return twice[key.Get].Items[0].Text == value.Get
                && twice[key.Get].Items[1].Number == number.Get
                && once.ToJson() == twice.ToJson();
        }));
    }

    [Fact]
    public void Damaged_documents_never_fail_otherwise()
    {
        var original = "{ \"a\": [1.5, \"té\\u00e9\", true, null], /* c */ \"b\": { \"c\": -2e3, }, }"u8.ToArray();
        var random = new Random(7);
        for (var i = 0; i < 5000; i++)
        {
            var bytes = original.ToArray();
            for (var n = random.Next(1, 4); n > 0; n--)
            {
                bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
            }

            try
            {
                Assert.NotNull(JsonInput.Read(bytes, "x"));
            }
            catch (InputException e)
            {
                Assert.All(e.Refusals, p => Assert.True(p.Place.Line >= 1 && p.Place.Column >= 1));
            }
        }
    }

    private static bool IsText(string text) =>
        System.Text.Unicode.Utf8.IsValid(Encoding.UTF8.GetBytes(text)) && Encoding.UTF8.GetString(Encoding.UTF8.GetBytes(text)) == text;

    private static JsonItem Read(string text) => JsonInput.Read(Encoding.UTF8.GetBytes(text), "job.json");

    private static IReadOnlyList<Refusal> Refused(ReadOnlySpan<byte> bytes, JsonLimits? limits = null)
    {
        try
        {
            JsonInput.Read(bytes, "job.json", limits);
        }
        catch (InputException e)
        {
            Assert.Equal("job.json", e.File);
            return e.Refusals;
        }

        Assert.Fail("The document was read.");
        return [];
    }
}
