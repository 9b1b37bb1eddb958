using System.Buffers.Binary;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>An SFTP session with a server that lies, never ends, or talks nonsense: it is left in bounded time, with bounded
/// memory.</summary>
public sealed class SftpSessionTests
{
    private const int MostMessage = 256 << 10;

    [Fact]
    public async Task Requests_are_what_the_protocol_says()
    {
        // By draft-ietf-secsh-filexfer-02, sections 3, 4, 6.3 and 6.5, byte by byte.
        var server = new Server((id, _) => Status(id, 0));
        await server.Session.GreetAsync().WaitAsync(Soon, Token);
        Assert.Equal([0, 0, 0, 5, 1, 0, 0, 0, 3], server.Got[0]);
        await server.Files.RemoveAsync("P1").WaitAsync(Soon, Token);
        Assert.Equal([0, 0, 0, 11, 13, 0, 0, 0, 1, 0, 0, 0, 2, (byte)'P', (byte)'1'], server.Got[1]);
        await server.Files.RenameAsync("é", "b").WaitAsync(Soon, Token);
        Assert.Equal([0, 0, 0, 16, 18, 0, 0, 0, 2, 0, 0, 0, 2, 0xC3, 0xA9, 0, 0, 0, 1, (byte)'b'], server.Got[2]);
        Assert.False(await server.Files.LinkAsync("a", "b"));
        Assert.Equal(3, server.Got.Count);
    }

    [Fact]
    public async Task Extensions_are_used_where_the_server_names_them()
    {
        var server = new Server(
            (id, type) => type == 3 ? Message(102, id, Text("h")) : Status(id, 0), "fsync@openssh.com", "posix-rename@openssh.com");
        await server.Session.GreetAsync().WaitAsync(Soon, Token);
        await server.Files.WriteAsync("a", new byte[] { 7 }).WaitAsync(Soon, Token);
        await server.Files.RenameAsync("a", "b").WaitAsync(Soon, Token);
        var said = server.Got.Select(g => Encoding.Latin1.GetString(g)).ToArray();
        Assert.Equal([1, 3, 6, 200, 4, 200], server.Got.Select(g => (int)g[4]));
        Assert.Contains("fsync@openssh.com", said[3], StringComparison.Ordinal);
        Assert.Contains("posix-rename@openssh.com", said[5], StringComparison.Ordinal);
        Assert.True(server.Files.IsAtRest);
    }

    [Fact]
    public async Task A_file_arrives_whole_in_whatever_pieces_it_comes()
    {
        var file = new byte[300_000];
        new Random(3).NextBytes(file);
        foreach (var most in new[] { 1000, 32768 })
        {
            var server = new Server((id, type, body) => type switch
            {
                3 => Message(102, id, Text("h")),
                5 when Long(body, 5) is var at && at < file.Length =>
                    Message(103, id, Bytes(file.AsSpan((int)at, (int)Math.Min(Math.Min(most, file.Length - at), Int(body, 13))))),
                5 => Status(id, 1),
                _ => Status(id, 0),
            });
            await server.Session.GreetAsync().WaitAsync(Soon, Token);
            foreach (var size in new long?[] { null, 0, file.Length, 2 * file.Length })
                Assert.Equal(file, await server.Files.ReadAsync("f", size, file.Length).WaitAsync(Soon, Token));
            Assert.Equal(file.Length, (await server.Files.ReadAsync("f", file.Length, file.Length - 1).WaitAsync(Soon, Token)).Length);
            Assert.True(server.Files.IsAtRest);
        }
    }

    [Fact]
    public async Task A_file_that_never_ends_is_read_up_to_its_limit()
    {
        var sent = 0L;
        var server = new Server((id, type, body) =>
        {
            sent += type == 5 ? Int(body, 13) : 0;
            return type switch
            {
                3 => Message(102, id, Text("h")),
                5 => Message(103, id, Bytes(new byte[Int(body, 13)])),
                _ => Status(id, 0),
            };
        });
        await server.Session.GreetAsync().WaitAsync(Soon, Token);
        Assert.Equal(100_001, (await server.Files.ReadAsync("f", long.MaxValue, 100_000).WaitAsync(Soon, Token)).Length);
        Assert.InRange(sent, 100_001, 1 << 20);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_folder_that_never_ends_is_left(bool hasNames)
    {
        var entry = Concat(Text("NAME.MPF"), Text("-rw-r--r-- NAME.MPF"), [0, 0, 0, 0]);
        var answers = 0;
        var server = new Server((id, type) =>
        {
            answers++;
            return type switch
            {
                11 => Message(102, id, Text("h")),
                12 when hasNames => Message(104, id, Concat([0, 0, 3, 232], Enumerable.Repeat(entry, 1000).SelectMany(e => e).ToArray())),
                12 => Message(104, id, [0, 0, 0, 0]),
                _ => Status(id, 0),
            };
        });
        await server.Session.GreetAsync().WaitAsync(Soon, Token);
        Assert.Null(await server.Files.NamesAsync(".").WaitAsync(Soon, Token));
        Assert.InRange(answers, 2, 10_000);
    }

    public static TheoryData<string, byte[]> Nonsense => new()
    {
        { "announced", [0xFF, 0xFF, 0xFF, 0xFF, 101] },
        { "announced", [0, 4, 0, 1, 101] },
        { "announced", [0, 0, 0, 4, 101, 0, 0, 0] },
        { "not asked", Message(101, 77, [0, 0, 0, 0]) },
        { "not asked", [0, 0, 0, 5, 2, 0, 0, 0, 3] },
        { "too early", Message(101, 1, [0, 0]) },
        { "too early", Message(101, 1, [0, 0, 0, 4, 0x7F, 0xFF, 0xFF, 0xFF, 1]) },
        { "expected", Message(104, 1, [0, 0, 0, 0]) },
        { "expected", Message(255, 1, []) },
    };

    [Theory]
    [MemberData(nameof(Nonsense))]
    public async Task Nonsense_ends_the_session(string word, byte[] answer)
    {
        var server = new Server((_, _) => answer);
        await server.Session.GreetAsync().WaitAsync(Soon, Token);
        var lost = await Assert.ThrowsAsync<SftpLostException>(() => server.Files.RemoveAsync("P1").WaitAsync(Soon, Token));
        Assert.Contains(word, lost.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task What_was_not_asked_for_is_not_listened_to_for_ever()
    {
        var server = new Server((id, _) => Status(id, 0));
        await server.Session.GreetAsync().WaitAsync(Soon, Token);
        Assert.False(server.Session.Receive(Message(103, 5, Bytes(new byte[1000]))));
        Assert.False(server.Session.IsAtRest);
        Assert.False(server.Session.Receive(new byte[MostMessage]));
        await Assert.ThrowsAsync<SftpLostException>(() => server.Files.RemoveAsync("P1"));
        Assert.Single(server.Got);
    }

    [Fact]
    public async Task More_than_was_asked_for_is_not_taken()
    {
        var server = new Server((id, type, body) => type == 3
            ? Message(102, id, Text("h"))
            : Message(103, id, Bytes(new byte[Int(body, 13) + 1])));
        await server.Session.GreetAsync().WaitAsync(Soon, Token);
        var lost = await Assert.ThrowsAsync<SftpLostException>(() => server.Files.ReadAsync("f", 10, 100).WaitAsync(Soon, Token));
        Assert.Contains("were asked", lost.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Another_version_is_refused_in_words()
    {
        var server = new Server((id, _) => Status(id, 0)) { Version = 6 };
        var lost = await Assert.ThrowsAsync<SftpLostException>(() => server.Session.GreetAsync().WaitAsync(Soon, Token));
        Assert.Contains("version 6", lost.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_server_s_words_are_repeated_in_one_short_line()
    {
        var words = "no\r\n\u001b[31mroom" + new string('x', 1000);
        var server = new Server((id, _) => Message(101, id, Concat([0, 0, 0, 4], Text(words), Text("en"))));
        await server.Session.GreetAsync().WaitAsync(Soon, Token);
        var refused = await Assert.ThrowsAsync<SftpStatusException>(() => server.Files.RemoveAsync("P1").WaitAsync(Soon, Token));
        Assert.StartsWith("the server answered 4 (no   [31mroomxxx", refused.Message, StringComparison.Ordinal);
        Assert.InRange(refused.Message.Length, 200, 250);
    }

    // However the stream is cut into pieces, and whatever byte of it is changed, nothing but an answer or a lost session comes of it.
    [Fact]
    public async Task Any_changed_byte_gives_an_answer_or_a_lost_session()
    {
        var random = new Random(17);
        for (var n = 0; n < 300; n++)
        {
            byte[] Changed(uint id, byte type)
            {
                var answer = type == 11
                    ? Message(102, id, Text("h"))
                    : Message(104, id, Concat([0, 0, 0, 1], Text("A"), Text("A"), [0, 0, 0, 15], new byte[8 + 8 + 4 + 8]));
                answer[random.Next(4, answer.Length)] ^= (byte)(1 << random.Next(8));
                return answer;
            }

            var server = new Server(Changed) { Piece = random.Next(1, 20) };
            await server.Session.GreetAsync().WaitAsync(Soon, Token);
            try
            {
                await server.Files.NamesAsync(".").WaitAsync(Soon, Token);
            }
            catch (Exception e) when (e is SftpLostException or SftpStatusException)
            {
                Assert.NotEmpty(e.Message);
            }
        }
    }

    private static TimeSpan Soon => TimeSpan.FromMinutes(1);

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    private static byte[] Status(uint id, uint code) => Message(101, id, Concat(Number(code), Text("words"), Text("en")));

    private static byte[] Message(byte type, uint id, byte[] rest) => Concat(Number((uint)(5 + rest.Length)), [type], Number(id), rest);

    private static byte[] Text(string text) => Bytes(Encoding.UTF8.GetBytes(text));

    private static byte[] Bytes(ReadOnlySpan<byte> bytes) => Concat(Number((uint)bytes.Length), bytes.ToArray());

    private static byte[] Number(uint number)
    {
        var bytes = new byte[4];
        BinaryPrimitives.WriteUInt32BigEndian(bytes, number);
        return bytes;
    }

    private static byte[] Concat(params byte[][] parts) => [.. parts.SelectMany(p => p)];

    private static int Int(byte[] body, int at) => BinaryPrimitives.ReadInt32BigEndian(body.AsSpan(at));

    private static long Long(byte[] body, int at) => BinaryPrimitives.ReadInt64BigEndian(body.AsSpan(at));

    // Answers each request at once, as it is told to. What it is told gets the number, the type and what follows them.
    private sealed class Server
    {
        public Server(Func<uint, byte, byte[]> answer, params string[] extensions) : this((id, type, _) => answer(id, type), extensions)
        {
        }

        public Server(Func<uint, byte, byte[], byte[]> answer, params string[] extensions)
        {
            Session = new((bytes, count) =>
            {
                var got = bytes[..count];
                Got.Add(got);
                var said = got[4] == 1
                    ? Concat(Number((uint)(5 + Names(extensions).Length)), [2], Number(Version), Names(extensions))
                    : answer((uint)Int(got, 5), got[4], got[9..]);
                for (var at = 0; at < said.Length; at += Piece)
                    Session!.Receive(said.AsSpan(at, Math.Min(Piece, said.Length - at)));
            });
            Files = new(Session);
        }

        public uint Version { get; init; } = 3;

        public int Piece { get; init; } = int.MaxValue / 2;

        public SftpSession Session { get; }

        public SftpFiles Files { get; }

        public List<byte[]> Got { get; } = [];

        private static byte[] Names(string[] extensions) => Concat([.. extensions.SelectMany(e => new[] { Text(e), Text("1") })]);
    }
}
