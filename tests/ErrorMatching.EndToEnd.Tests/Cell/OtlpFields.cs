using System.Buffers.Binary;
using System.Text;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A message in the wire format of Protocol Buffers: its fields by number, nothing known of their meaning. Source:
/// protobuf.dev/programming-guides/encoding.</summary>
internal sealed class OtlpFields
{
    private readonly List<(int Number, ulong Value, ReadOnlyMemory<byte> Bytes)> _fields = [];

    /// <summary>Reads a message; what is none throws.</summary>
    public OtlpFields(ReadOnlyMemory<byte> message)
    {
        var at = 0;
        while (at < message.Length)
        {
            var key = Varint(message.Span, ref at);
            var (value, bytes) = (key & 7) switch
            {
                0 => (Varint(message.Span, ref at), ReadOnlyMemory<byte>.Empty),
                1 => (BinaryPrimitives.ReadUInt64LittleEndian(Taken(message, ref at, 8).Span), default),
                2 => (0UL, Taken(message, ref at, checked((int)Varint(message.Span, ref at)))),
                5 => (BinaryPrimitives.ReadUInt32LittleEndian(Taken(message, ref at, 4).Span), default),
                var type => throw new InvalidDataException($"Wire type {type}."),
            };
            _fields.Add(((int)(key >> 3), value, bytes));
        }
    }

    /// <summary>The messages of a field.</summary>
    public IEnumerable<OtlpFields> Messages(int number) => _fields.Where(f => f.Number == number).Select(f => new OtlpFields(f.Bytes));

    /// <summary>The text of a field; empty where it is not there.</summary>
    public string Text(int number) => Encoding.UTF8.GetString(Bytes(number).Span);

    /// <summary>The bytes of a field as hexadecimal digits; empty where it is not there.</summary>
    public string Hex(int number) => Convert.ToHexStringLower(Bytes(number).Span);

    /// <summary>The number of a field; 0 where it is not there.</summary>
    public ulong Value(int number) => _fields.LastOrDefault(f => f.Number == number).Value;

    /// <summary>True if a field is there.</summary>
    public bool Has(int number) => _fields.Any(f => f.Number == number);

    private ReadOnlyMemory<byte> Bytes(int number) => _fields.LastOrDefault(f => f.Number == number).Bytes;

    private static ReadOnlyMemory<byte> Taken(ReadOnlyMemory<byte> message, ref int at, int length)
    {
        var taken = message.Slice(at, length);
        at += length;
        return taken;
    }

    private static ulong Varint(ReadOnlySpan<byte> bytes, ref int at)
    {
        var value = 0UL;
        for (var shift = 0; ; shift += 7)
        {
            var b = bytes[at++];
            value |= (ulong)(b & 0x7F) << shift;
            if (b < 0x80)
            {
                return value;
            }
        }
    }
}
