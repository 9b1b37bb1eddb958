using ErrorMatching.Refusals;

namespace ErrorMatching.Json;

/// <summary>A JSON Schema of draft 2020-12, restricted to keywords that are checked exactly.</summary>
/// <remarks>Checked keywords: <c>type, enum, const, required, properties, additionalProperties: false, items, prefixItems, minItems,
/// maxItems, minimum, maximum, exclusiveMinimum, exclusiveMaximum, minLength, pattern, oneOf, anyOf, $ref</c> to <c>#</c> or
/// <c>#/$defs/NAME</c>. Informative keywords: <c>$schema, $id, $defs, $comment, title, description, examples, default</c>. Every other
/// keyword is refused, so that a schema never claims anything that is not checked.</remarks>
public sealed class JsonSchema
{
    private readonly SchemaRule _root;

    private JsonSchema(SchemaRule root) => _root = root;

    /// <summary>What it says of a whole document.</summary>
    public SchemaPlace Root => SchemaPlace.Of([_root]);

    /// <summary>Parses a schema.</summary>
    /// <param name="bytes">UTF-8 text.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="InputException">The bytes are not JSON (as for <see cref="JsonInput.Read"/>) or not a schema of the subset
    /// (<c>schema</c>).</exception>
    public static JsonSchema Parse(ReadOnlySpan<byte> bytes, string file)
    {
        var parser = new SchemaParser(JsonInput.Read(bytes, file));
        var root = parser.Parse();
        return parser.Problems.Count == 0 ? new(root) : throw new InputException(file, parser.Problems);
    }

    /// <summary>Returns all violations of the schema, in the order of the document; empty if there are none. After 100 problems,
    /// <c>too-many-problems</c> is the last.</summary>
    public IReadOnlyList<Refusal> Check(JsonItem document)
    {
        ArgumentNullException.ThrowIfNull(document);
        var findings = new List<Finding>();
        SchemaChecker.Check(_root, document, findings);

        // Identical findings of two rules are reported once. The sort is stable, so problems at one place keep the order of the rules.
        var problems = findings.Select(f => f.Problem).Distinct();
        return ProblemList.Shortened([.. problems.OrderBy(p => p.Place.Line).ThenBy(p => p.Place.Column)]);
    }
}
