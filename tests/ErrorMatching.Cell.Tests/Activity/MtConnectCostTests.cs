using System.Buffers;
using System.Text;
using System.Xml;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>An answer of an agent that repeats one thing for ever takes time in proportion to its size, and reading it ends when the time
/// for the answer does.</summary>
public sealed class MtConnectCostTests
{
    private const string Head =
        "<MTConnectStreams><Streams><DeviceStream name=\"V\"><ComponentStream component=\"Path\" componentId=\"p\">";
    private static readonly MtConnectSettings Settings = new(new("http://127.0.0.1"), null, false);

    [Fact]
    public void Answers() => ReadingCost.IsLinear(
        bytes =>
        {
            try
            {
                Read(bytes, CancellationToken.None);
            }
            catch (Exception e) when (e is XmlException or StateException)
            {
                // It may refuse them.
            }
        },
        ("<MTConnectStreams", " a§=\"1\"", ""),
        (Head + "<Execution", " a§=\"1\"", ""),
        (Head + "<Execution", " a§:b=\"1\"", ""),
        (Head + "<Execution", " xmlns:a§=\"u§\"", ""),
        (Head, "<Execution", ""),
        (Head, "<Execution>", ""),
        (Head, "<x>", ""),
        (Head, "<x/>", ""),
        (Head, "<x a=\"1\"/>", ""),
        (Head, "<Fault type=\"SYSTEM\"/>", ""),
        (Head, "<DeviceStream name=\"V§\"/>", ""),
        (Head, "<ComponentStream componentId=\"c§\"/>", ""),
        (Head + "<Program>", "O1 ", ""),
        (Head, "<!-- -->", ""),
        (Head + "<!--", "-", ""),
        (Head, "<?p?>", ""),
        (Head + "<![CDATA[", "]", ""),
        (Head + "<Program>", "&amp;", ""));

    [Fact]
    public void Reading_ends_with_the_time_for_the_answer()
    {
        using var end = new CancellationTokenSource();
        using var document = new Pieces(
            Encoding.ASCII.GetBytes(Head + string.Concat(Enumerable.Repeat("<x/>", 1 << 20))), piece =>
            {
                if (piece == 3) end.Cancel();
            });
        Assert.Throws<OperationCanceledException>(
            () => new MtConnectStreams(Settings, "agent", Wrong).Read(document.Memory, end.Token));
        Assert.InRange(document.Count, 3, 4);
    }

    private static void Read(byte[] bytes, CancellationToken cancellation) =>
        new MtConnectStreams(Settings, "agent", Wrong).Read(bytes, cancellation);

    private static StateException Wrong(string found) => new(StateCodes.Wrong, Recorded.StateWrong.With("agent", found));

    /// <summary>Memory that says when a piece of it is read.</summary>
    private sealed class Pieces(byte[] bytes, Action<int> reading) : MemoryManager<byte>
    {
        public int Count { get; private set; }

        public override Span<byte> GetSpan()
        {
            reading(++Count);
            return bytes;
        }

        public override MemoryHandle Pin(int elementIndex = 0) => throw new NotSupportedException();

        public override void Unpin() => throw new NotSupportedException();

        protected override void Dispose(bool disposing)
        {
        }
    }
}
