using System.Text.Json;
using System.Text.Json.Nodes;

namespace ErrorMatching.Testing;

/// <summary>Checks of documents that are written and read again.</summary>
internal static class DocumentCheck
{
    // A document has nine decimals, so what is computed from two of its numbers may differ in the last one.
    private const double Rounding = 2.5e-9;

    /// <summary>Checks that a document that was read and written again is the same, but for the rounding of computed numbers, and that the
    /// next one is the same to the last byte.</summary>
    public static void IsReadAndWritten(byte[] document, Func<byte[], byte[]> readAndWrite, params string[] without)
    {
        var again = readAndWrite(document);
        IsSame(JsonNode.Parse(document), JsonNode.Parse(again), "$", without);
        Assert.Equal(again, readAndWrite(again));
    }

    /// <summary>The document with one value after the other removed or replaced.</summary>
    public static IEnumerable<(string Path, byte[] Json)> Mutations(byte[] document)
    {
        foreach (var (path, count) in Values(JsonNode.Parse(document)!).Select((v, i) => (v, i)).ToArray())
        {
            foreach (var value in new[] { null, "null", "-7", "1.5", "\"text\"", "true", "[]", "{}" })
            {
                var copy = JsonNode.Parse(document)!;
                var node = Nodes(copy).ElementAt(count);
                if (node.Parent is JsonObject parent && value is null)
                {
                    parent.Remove(node.Name!);
                }
                else if (node.Parent is JsonObject owner)
                {
                    owner[node.Name!] = JsonNode.Parse(value!);
                }
                else if (node.Parent is JsonArray list && value is not null)
                {
                    list[node.Index] = JsonNode.Parse(value);
                }
                else
                {
                    ((JsonArray)node.Parent).RemoveAt(node.Index);
                }

                yield return (path, JsonSerializer.SerializeToUtf8Bytes(copy));
            }
        }
    }

    private static IEnumerable<string> Values(JsonNode root) =>
        Nodes(root).Select(n => n.Name is null ? $"{n.Parent.GetPath()}[{n.Index}]" : $"{n.Parent.GetPath()}.{n.Name}");

    private static IEnumerable<(JsonNode Parent, string? Name, int Index)> Nodes(JsonNode? node)
    {
        if (node is JsonObject members)
        {
            foreach (var (name, value) in members.ToArray())
            {
                yield return (members, name, 0);
                foreach (var inner in Nodes(value))
                {
                    yield return inner;
                }
            }
        }
        else if (node is JsonArray items)
        {
            for (var i = 0; i < items.Count; i++)
            {
                yield return (items, null, i);
                foreach (var inner in Nodes(items[i]))
                {
                    yield return inner;
                }
            }
        }
    }

    private static void IsSame(JsonNode? expected, JsonNode? actual, string path, string[] without)
    {
        if (without.Contains(path, StringComparer.Ordinal))
        {
            return;
        }

        switch (expected, actual)
        {
            case (JsonObject a, JsonObject b):
                Assert.Equal(a.Select(m => m.Key), b.Select(m => m.Key));
                foreach (var (name, value) in a)
                {
                    IsSame(value, b[name], $"{path}.{name}", without);
                }

                break;
            case (JsonArray a, JsonArray b):
                Assert.True(a.Count == b.Count, path);
                for (var i = 0; i < a.Count; i++)
                {
                    IsSame(a[i], b[i], $"{path}[{i}]", without);
                }

                break;
            default:
                var isSame = JsonNode.DeepEquals(expected, actual)
                    || (expected?.GetValueKind() == JsonValueKind.Number && actual?.GetValueKind() == JsonValueKind.Number
                        && Math.Abs(expected.GetValue<double>() - actual.GetValue<double>()) <= Rounding);
                Assert.True(isSame, $"{path}: {expected} became {actual}");
                break;
        }
    }
}
