using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Json.Tests;

public sealed class JsonSchemaTests
{
    [Theory]
    [InlineData("""{ "items": { "type": "string" } }""", "[", "5,", "]", "wrong-type", "$[100]")]
    [InlineData("""{ "properties": { "b": {} }, "additionalProperties": false }""", "{", "\"a#\": 1,", "}", "unknown-key", "$.a100")]
    [InlineData("""{ "items": { "oneOf": [{ "type": "string" }, { "type": "boolean" }] } }""", "[", "5,", "]", "wrong-type", "$[100]")]
    public void After_a_hundred_findings_a_last_one_says_that_there_are_more(
        string schema, string open, string part, string close, string code, string path)
    {
        var text = open + string.Concat(Enumerable.Range(0, 2000).Select(i => part.Replace("#", $"{i}", StringComparison.Ordinal))) + close;
        var problems = JsonSchema.Parse(Encoding.UTF8.GetBytes(schema), "schema").Check(JsonInput.Read(Encoding.UTF8.GetBytes(text), "x"));
        Assert.Equal(101, problems.Count);
        Assert.All(problems.SkipLast(1), p => Assert.Equal(code, p.Code));
        Assert.Equal(("too-many-problems", path), (problems[^1].Code, problems[^1].Place.Path));
    }

    [Theory]
    [InlineData("""{ "type": "string" }""", "5", "wrong-type", "found the number 5; expected text")]
    [InlineData("""{ "type": ["string", "number"] }""", "true", "wrong-type", "found true; expected text or a number")]
    [InlineData("""{ "type": "integer" }""", "1.5", "wrong-type", "found the number 1.5; expected a whole number")]
    [InlineData("""{ "type": "object" }""", "[]", "wrong-type", "found an empty list; expected an object")]
    [InlineData("""{ "type": "array" }""", "{}", "wrong-type", "found an object; expected a list")]
    [InlineData("""{ "type": "boolean" }""", "null", "wrong-type", "found null; expected true or false")]
    [InlineData(
        """{ "enum": ["part", "counterpart", 3] }""",
        "\"parts\"",
        "not-one-of",
        "found the text \"parts\"; expected \"part\", \"counterpart\" or 3")]
    [InlineData("""{ "const": "mating" }""", "\"freeform\"", "not-one-of", "found the text \"freeform\"; expected \"mating\"")]
    [InlineData("""{ "required": ["a"] }""", "{}", "missing-key", "found no key \"a\"; expected the key \"a\"")]
    [InlineData("""{ "minItems": 2 }""", "[1]", "too-few-items", "found a list of 1; expected at least 2")]
    [InlineData("""{ "maxItems": 1 }""", "[1, 2]", "too-many-items", "found a list of 2; expected at most 1")]
    [InlineData("""{ "minimum": 1 }""", "0.5", "too-small", "found the number 0.5; expected at least 1")]
    [InlineData("""{ "exclusiveMinimum": 0 }""", "0", "too-small", "found the number 0; expected more than 0")]
    [InlineData("""{ "maximum": 2 }""", "2.5", "too-large", "found the number 2.5; expected at most 2")]
    [InlineData("""{ "exclusiveMaximum": 2 }""", "2", "too-large", "found the number 2; expected less than 2")]
    [InlineData("""{ "minLength": 1 }""", "\"\"", "too-short", "found the text \"\"; expected text that is not empty")]
    [InlineData("""{ "minLength": 2 }""", "\"é\"", "too-short", "found the text \"é\"; expected at least 2 characters")]
    [InlineData("""{ "minLength": 2 }""", "\"😀\"", "too-short", "found the text \"😀\"; expected at least 2 characters")]
    [InlineData(
        """{ "pattern": "^N[0-9]+$" }""", "\"n1\"", "pattern-mismatch", "found the text \"n1\"; expected text that matches ^N[0-9]+$")]
    [InlineData(
        """{ "pattern": "^N[0-9]+$", "title": "a block number" }""",
        "\"n1\"",
        "pattern-mismatch",
        "found the text \"n1\"; expected a block number")]
    public void A_value_that_breaks_a_rule_is_reported(string schema, string document, string code, string message)
    {
        var problem = Assert.Single(Check(schema, document));

        Assert.Equal((code, message + ".", "$"), (problem.Code, problem.Message, problem.Place.Path));
    }

    [Theory]
    [InlineData("""{ "type": "integer" }""", "2.0")]
    [InlineData("""{ "enum": [1.0, null] }""", "1")]
    [InlineData("""{ "enum": [1.0, null] }""", "null")]
    [InlineData("""{ "minimum": 1, "maximum": 1 }""", "1")]
    [InlineData("""{ "minItems": 1, "maxItems": 1 }""", "[0]")]
    [InlineData("""{ "minLength": 1 }""", "\"😀\"")]
    [InlineData("""{ "pattern": "b" }""", "\"abc\"")]
    [InlineData("""{ "minimum": 5, "minLength": 5 }""", "[]")]
    [InlineData("""{ "properties": { "a": { "type": "number" } } }""", """{ "b": 1 }""")]
    [InlineData("""{ "anyOf": [ { "minimum": 5 }, { "maximum": 9 } ] }""", "7")]
    [InlineData(
        """{ "title": "t", "description": "d", "examples": [1], "default": 1, "$comment": "c", "$id": "i", "$schema": "s" }""", "[1, {}]")]
    public void A_value_that_keeps_the_rules_passes(string schema, string document) => Assert.Empty(Check(schema, document));

    [Fact]
    public void All_problems_are_reported_in_the_order_of_the_document()
    {
        const string schema = """
            { "properties": { "a": { "type": "number" }, "b": { "prefixItems": [ { "type": "string" } ], "items": { "minimum": 0 } } }, "additionalProperties": false, "required": ["c"] }
            """;

        var problems = Check(schema, """{ "x": 1, "b": [ 2, 1, -1 ], "a": "1" }""");

        Assert.Equal(["$", "$.x", "$.b[0]", "$.b[2]", "$.a"], problems.Select(p => p.Place.Path));
        Assert.Equal(["missing-key", "unknown-key", "wrong-type", "too-small", "wrong-type"], problems.Select(p => p.Code));
    }

    [Fact]
    public void A_number_of_hundreds_of_digits_is_not_repeated_in_full()
    {
        var problem = Assert.Single(Check("""{ "properties": { "x": { "maximum": 5 } } }""", $$"""{ "x": 1{{new string('0', 300)}} }"""));
        Assert.Equal($"found the number 1{new string('0', 39)}...; expected at most 5.", problem.Message);
    }

    [Theory]
    [InlineData("toleranceMM", "toleranceMm")]
    [InlineData("tolerance", "toleranceMm")]
    [InlineData("kidn", "kind")]
    [InlineData("KIND", "kind")]
    public void An_unknown_key_is_answered_with_the_nearest_known_one(string typed, string known)
    {
        var problem = Assert.Single(Check(
            """{ "properties": { "kind": {}, "toleranceMm": {} }, "additionalProperties": false }""", $$"""{ "{{typed}}": 1 }"""));

        Assert.Equal(
            ("unknown-key", $"\"{known}\"", 1, 3), (problem.Code, problem.Expected, problem.Place.Line, problem.Place.Column));
        Assert.EndsWith($"did you mean \"{known}\"?", problem.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void An_unknown_key_that_resembles_nothing_is_answered_with_all_known_ones()
    {
        var problem = Assert.Single(Check(
            """{ "properties": { "kind": {}, "toleranceMm": {} }, "additionalProperties": false }""", """{ "colour": 1 }"""));

        Assert.Equal("the key \"colour\" is not known here; known are kind, toleranceMm.", problem.Message);
    }

    [Fact]
    public void References_are_followed_even_when_they_recur()
    {
        const string schema =
            """{ "$ref": "#/$defs/tree", "$defs": { "tree": { "type": "array", "items": { "$ref": "#/$defs/tree" } } } }""";

        Assert.Empty(Check(schema, "[[], [[]]]"));
        Assert.Equal("$[1][0]", Assert.Single(Check(schema, "[[], [3]]")).Place.Path);
        Assert.Equal(
            "$.a.a",
            Assert.Single(Check("""{ "type": "object", "properties": { "a": { "$ref": "#" } } }""", """{ "a": { "a": 1 } }""")).Place.Path);
    }

    [Fact]
    public void Of_alternatives_the_one_that_was_meant_is_explained()
    {
        const string schema = """
            { "oneOf": [
              { "type": "object", "properties": { "kind": { "const": "line" }, "n": { "type": "number" } }, "required": ["kind", "n"], "additionalProperties": false },
              { "type": "object", "properties": { "kind": { "const": "curve" }, "degree": { "type": "number" } }, "required": ["kind"], "additionalProperties": false },
              { "type": "string" } ] }
            """;

        Assert.Equal("found no key \"n\"; expected the key \"n\".", Assert.Single(Check(schema, """{ "kind": "line" }""")).Message);
        Assert.Equal("$.degree", Assert.Single(Check(schema, """{ "kind": "curve", "degree": "high" }""")).Place.Path);

        Assert.Equal(
            "found the text \"lime\"; expected \"line\" or \"curve\".", Assert.Single(Check(schema, "{ \"kind\": \"lime\" }")).Message);
        Assert.Empty(Check(schema, "\"short\""));
        Assert.Equal("found no key \"kind\"; expected the key \"kind\".", Assert.Single(Check(schema, "{}")).Message);
    }

    [Fact]
    public void Constants_that_tell_alternatives_apart_are_listed_when_none_fits()
    {
        const string schema = """
            { "oneOf": [
              { "properties": { "kind": { "const": "line" } } },
              { "properties": { "kind": { "const": "curve" } } } ] }
            """;

        var problem = Assert.Single(Check(schema, """{ "kind": "lime" }"""));

        Assert.Equal(
            ("not-one-of", "$.kind", "found the text \"lime\"; expected \"line\" or \"curve\"."),
            (problem.Code, problem.Place.Path, problem.Message));
    }

    [Fact]
    public void Types_of_all_alternatives_are_listed_when_none_fits() =>
        Assert.Equal(
            "found true; expected a number or a list.",
            Assert.Single(Check("""{ "anyOf": [ { "type": "number" }, { "type": "array" } ] }""", "true")).Message);

    [Fact]
    public void Alternatives_are_named_by_their_titles()
    {
        const string schema = """{ "anyOf": [ { "type": "string", "pattern": "^a", "title": "a word with a" }, { "$ref": "#/$defs/b" }, { "enum": [1] } ], "$defs": { "b": { "minLength": 9, "title": "a long word" } } }""";

        Assert.Equal("found the text \"bcd\"; expected a word with a, a long word or 1.", Assert.Single(Check(schema, "\"bcd\"")).Message);
    }

    [Fact]
    public void A_value_that_fits_two_of_one_is_refused() =>
        Assert.Equal("several-alternatives", Assert.Single(Check("""{ "oneOf": [ { "minimum": 5 }, { "maximum": 9 } ] }""", "7")).Code);

    [Theory]
    [InlineData("""{ "format": "date" }""", "$.format")]
    [InlineData("""{ "properties": { "a": { "maxLength": 3 } } }""", "$.properties.a.maxLength")]
    [InlineData("""{ "additionalProperties": true }""", "$.additionalProperties")]
    [InlineData("""{ "type": "text" }""", "$.type")]
    [InlineData("""{ "$ref": "#/$defs/none" }""", "$.$ref")]
    [InlineData("""{ "$ref": "other.json" }""", "$.$ref")]
    [InlineData("""{ "$ref": "#" }""", "$.$ref")]
    [InlineData("""{ "anyOf": [ { "$ref": "#" } ] }""", "$.anyOf[0].$ref")]
    [InlineData("""{ "enum": [[1]] }""", "$.enum[0]")]
    [InlineData("""{ "pattern": "(" }""", "$.pattern")]
    [InlineData("""{ "minItems": -1 }""", "$.minItems")]
    [InlineData("""{ "minimum": "1" }""", "$.minimum")]
    [InlineData("""{ "oneOf": {} }""", "$.oneOf")]
    [InlineData("""{ "properties": [] }""", "$.properties")]
    [InlineData("true", "$")]
    public void A_schema_never_claims_what_is_not_checked(string schema, string path)
    {
        var e = Assert.Throws<InputException>(() => JsonSchema.Parse(Encoding.UTF8.GetBytes(schema), "schema.json"));

        var problem = Assert.Single(e.Refusals);
        Assert.Equal(("schema", path), (problem.Code, problem.Place.Path));
    }

    private static IReadOnlyList<Refusal> Check(string schema, string document) =>
        JsonSchema.Parse(Encoding.UTF8.GetBytes(schema), "schema.json").Check(JsonInput.Read(Encoding.UTF8.GetBytes(document), "job.json"));
}
