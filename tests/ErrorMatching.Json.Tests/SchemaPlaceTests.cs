namespace ErrorMatching.Json.Tests;

/// <summary>What a schema says of one place, for forms.</summary>
public sealed class SchemaPlaceTests
{
    private static readonly SchemaPlace Root = JsonSchema.Parse(
        """
        {
          "properties": {
            "name": { "type": "string" },
            "size": { "$ref": "#/$defs/size", "default": 0.50 },
            "shape": {
              "oneOf": [
                { "properties": { "kind": { "const": "round" }, "radius": { "$ref": "#/$defs/size" } }, "required": ["kind", "radius"] },
                { "properties": { "kind": { "const": "flat" }, "sides": { "type": "array", "minItems": 2, "items": { "type": "integer" } } } }
              ]
            },
            "degree": { "anyOf": [{ "const": "auto" }, { "type": "integer" }, { "type": "boolean" }], "default": "auto" }
          },
          "required": ["name"],
          "$defs": { "size": { "type": "number" } }
        }
        """u8,
        "s.json").Root;

    [Fact]
    public void It_has_the_keys_words_and_types_of_all_alternatives()
    {
        var (shape, degree) = (Root.Member("shape"), Root.Member("degree"));
        Assert.Equal(["name", "size", "shape", "degree"], Root.Keys);
        Assert.Equal((true, false), (Root.Requires("name"), Root.Requires("size")));
        Assert.Equal(["kind", "radius", "sides"], shape.Keys);
        Assert.Equal(["round", "flat"], shape.Member("kind").Words);
        Assert.Equal((true, true, true, false), (degree.TakesTexts, degree.TakesNumbers, degree.TakesFlags, degree.TakesLists));
        Assert.Equal(("0.50", "auto", ""), (Root.Member("size").Default, degree.Default, Root.Member("name").Default));
        var sides = shape.Member("sides");
        Assert.Equal((true, 2, true), (sides.TakesLists, sides.LeastItems, sides.Item.TakesNumbers));
    }

    [Fact]
    public void An_object_chooses_the_alternative_with_its_constant()
    {
        var shape = Root.Member("shape");
        Assert.Equal(["kind", "radius"], shape.Meant(k => k == "kind" ? "round" : null).Keys);
        Assert.Equal(["kind", "sides"], shape.Meant(k => k == "kind" ? "flat" : "").Keys);
        Assert.Equal(shape.Keys, shape.Meant(_ => null).Keys);
    }

    [Fact]
    public void A_place_that_is_not_described_takes_nothing()
    {
        var none = Root.Member("colour");
        Assert.Equal((0, 0, false, ""), (none.Keys.Count, none.LeastItems, none.TakesTexts, none.Item.Member("x").Default));
    }
}
