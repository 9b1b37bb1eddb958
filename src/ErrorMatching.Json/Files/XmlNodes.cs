using System.Globalization;
using System.Xml;

namespace ErrorMatching.Json;

/// <summary>XML of another program, read node by node from the beginning to the end. No document type, nothing outside the document, and
/// no node that is longer than any program writes.</summary>
/// <remarks>The time of <see cref="XmlReader"/> grows with the square of the number of attributes of an element (.NET 10: 1.5 million take
/// 40 s), because it compares their names. So the reader gets a limited number of bytes for each node.</remarks>
public sealed class XmlNodes : IDisposable
{
    /// <summary>The longest node, in bytes: a start tag with its attributes, or a piece of text between two tags.</summary>
    public const int MostNodeBytes = 1 << 18;

    private readonly Source _source;

    /// <summary>Begins to read a document.</summary>
    /// <param name="bytes">The document, in any encoding that XML declares.</param>
    public XmlNodes(ReadOnlyMemory<byte> bytes)
    {
        _source = new(bytes, TooLong);
        Xml = XmlReader.Create(_source, new XmlReaderSettings
        {
            DtdProcessing = DtdProcessing.Prohibit,
            XmlResolver = null,
            IgnoreWhitespace = true,
        });
    }

    /// <summary>The current node. Move on with <see cref="Read"/> only; what is read of an element counts as part of it.</summary>
    public XmlReader Xml { get; }

    /// <summary>Moves to the next node; false at the end. Comments and processing instructions are nodes, too.</summary>
    /// <exception cref="XmlException">The document is not well-formed, declares a document type, or has too long a node.</exception>
    /// <exception cref="ArgumentException">Its encoding is not known.</exception>
    /// <exception cref="NotSupportedException">Its encoding is not known.</exception>
    public bool Read()
    {
        _source.Left = MostNodeBytes;
        return Xml.Read();
    }

    /// <summary>Releases the document.</summary>
    public void Dispose()
    {
        Xml.Dispose();
        _source.Dispose();
    }

    private XmlException TooLong()
    {
        var place = (IXmlLineInfo)Xml;
        return new(
            string.Create(CultureInfo.InvariantCulture, $"A tag or a text has more than {MostNodeBytes} bytes."),
            null,
            Math.Max(1, place.LineNumber),
            Math.Max(1, place.LinePosition));
    }

    // A reader that needs more of the document asks for it; what it has already, it does not ask for again.
    private sealed class Source(ReadOnlyMemory<byte> bytes, Func<XmlException> tooLong) : Stream
    {
        private int _at;

        public int Left { get; set; } = MostNodeBytes;

        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => false;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

        public override int Read(Span<byte> buffer)
        {
            if (Left <= 0)
            {
                throw tooLong();
            }

            var count = Math.Min(buffer.Length, bytes.Length - _at);
            bytes.Span.Slice(_at, count).CopyTo(buffer);
            (_at, Left) = (_at + count, Left - count);
            return count;
        }

        public override void Flush()
        {
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();
    }
}
