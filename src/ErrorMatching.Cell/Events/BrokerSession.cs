using System.Net;
using MQTTnet;
using MQTTnet.Adapter;
using MQTTnet.Diagnostics.Logger;
using MQTTnet.Exceptions;
using MQTTnet.Formatter;
using MQTTnet.Implementations;
using MQTTnet.Packets;
using MQTTnet.Protocol;

namespace ErrorMatching.Cell;

/// <summary>A connection to a broker that publishes one message at a time and waits until the broker has taken it over (quality of service
/// 2). Source: MQTT 5.0, sections 3 and 4.3.3.</summary>
/// <remarks>The packets are sent one by one instead of through the library's client, because that one numbers its packets itself: after a
/// broken connection, the broker must recognize by its number the message that it has already half received.</remarks>
internal sealed class BrokerSession : IDisposable
{
    // Longer than any silence of a session that lives: PingAsync is called every few seconds.
    private const ushort KeepAliveS = 60;
    private const uint ExpiryS = 86_400;
    private const uint MostBytesOfAnswer = 1 << 16;
    private readonly EventSettings _broker;
    private readonly TimeSpan _limit;
    private readonly BrokerTrust _trust;
    private readonly IMqttChannelAdapter _channel;

    private BrokerSession(EventSettings broker, BrokerTrust trust, TimeSpan limit)
    {
        (_broker, _trust, _limit) = (broker, trust, limit);
        _channel = new MqttClientAdapterFactory().CreateClientAdapter(
            new MqttClientOptions
            {
                ProtocolVersion = MqttProtocolVersion.V500,
                ChannelOptions = new MqttClientTcpOptions
                {
                    RemoteEndpoint = new DnsEndPoint(broker.Host.Trim('[', ']'), broker.Port),
                    TlsOptions = new MqttClientTlsOptions
                    {
                        UseTls = broker.IsEncrypted,
                        TargetHost = broker.Host.Trim('[', ']'),
                        CertificateValidationHandler = seen => trust.Accepts(seen.Certificate, seen.Chain, seen.SslPolicyErrors),
                    },
                },
            },
            null,
            MqttNetNullLogger.Instance);
    }

    /// <summary>Connects and logs in.</summary>
    /// <param name="broker">The broker.</param>
    /// <param name="client">Identifies the session at the broker.</param>
    /// <param name="isResumed">True to go on with the session before, with the numbers of its packets; false to begin a new one.</param>
    /// <param name="limit">The longest that one exchange with the broker may take.</param>
    /// <param name="cancellation">Cancels it.</param>
    /// <exception cref="BrokerException">It is not possible.</exception>
    public static async Task<BrokerSession> OpenAsync(
        EventSettings broker, string client, bool isResumed, TimeSpan limit, CancellationToken cancellation)
    {
        var password = BrokerFiles.Password(broker);
        var session = new BrokerSession(broker, new BrokerTrust(broker.PinnedKey, BrokerFiles.Authorities(broker)), limit);
        try
        {
            await session.TryAsync("connecting", session._channel.ConnectAsync, cancellation);
            await session.LogInAsync(
                new MqttConnectPacket
                {
                    ClientId = client,
                    CleanSession = !isResumed,
                    SessionExpiryInterval = ExpiryS,
                    KeepAlivePeriod = KeepAliveS,
                    MaximumPacketSize = MostBytesOfAnswer,
                    Username = broker.User,
                    Password = password,
                },
                cancellation);
            return session;
        }
        catch
        {
            session.Dispose();
            throw;
        }
    }

    /// <summary>Publishes a message; the broker has taken it over when this returns.</summary>
    /// <param name="number">Number of the packet, not 0. The same message always has the same, and no other of the last ones.</param>
    /// <param name="isAgain">True if it may have been sent before.</param>
    /// <param name="payload">The message.</param>
    /// <param name="cancellation">Cancels it.</param>
    /// <exception cref="BrokerException">The broker may or may not have it.</exception>
    public Task PublishAsync(ushort number, bool isAgain, byte[] payload, CancellationToken cancellation) => TryAsync(
        "publishing",
        async limited =>
        {
            await _channel.SendPacketAsync(
                new MqttPublishPacket
                {
                    Topic = _broker.Topic,
                    PacketIdentifier = number,
                    Dup = isAgain,
                    QualityOfServiceLevel = MqttQualityOfServiceLevel.ExactlyOnce,
                    PayloadFormatIndicator = MqttPayloadFormatIndicator.CharacterData,
                    ContentType = "application/json",
                    PayloadSegment = payload,
                },
                limited);
            var received = await AnswerAsync<MqttPubRecPacket>(p => p.PacketIdentifier == number, limited);
            if (received.ReasonCode is not (MqttPubRecReasonCode.Success or MqttPubRecReasonCode.NoMatchingSubscribers))
            {
                throw Of(BrokerError.Denied, $"publishing to {_broker.Topic}", Words(received.ReasonCode, received.ReasonString));
            }

            await _channel.SendPacketAsync(new MqttPubRelPacket { PacketIdentifier = number }, limited);
            var completed = await AnswerAsync<MqttPubCompPacket>(p => p.PacketIdentifier == number, limited);
            if (completed.ReasonCode != MqttPubCompReasonCode.Success)
            {
                throw Of(BrokerError.Away, "publishing", Words(completed.ReasonCode, completed.ReasonString));
            }
        },
        cancellation);

    /// <summary>Publishes what replaces the message before, and waits for no answer (quality of service 0). The broker keeps it for those
    /// who subscribe later.</summary>
    /// <param name="topic">The topic.</param>
    /// <param name="payload">The message.</param>
    /// <param name="life">How long the message is true.</param>
    /// <param name="cancellation">Cancels it.</param>
    /// <exception cref="BrokerException">The connection is broken.</exception>
    public Task AnnounceAsync(string topic, byte[] payload, TimeSpan life, CancellationToken cancellation) => TryAsync(
        "publishing",
        limited => _channel.SendPacketAsync(
            new MqttPublishPacket
            {
                Topic = topic,
                Retain = true,
                QualityOfServiceLevel = MqttQualityOfServiceLevel.AtMostOnce,
                MessageExpiryInterval = (uint)life.TotalSeconds,
                PayloadFormatIndicator = MqttPayloadFormatIndicator.CharacterData,
                ContentType = "application/json",
                PayloadSegment = payload,
            },
            limited),
        cancellation);

    /// <summary>Asks whether the broker is still there.</summary>
    /// <exception cref="BrokerException">It is not.</exception>
    public Task PingAsync(CancellationToken cancellation) => TryAsync(
        "asking whether it is there",
        async limited =>
        {
            await _channel.SendPacketAsync(MqttPingReqPacket.Instance, limited);
            await AnswerAsync<MqttPingRespPacket>(_ => true, limited);
        },
        cancellation);

    /// <summary>Says goodbye.</summary>
    /// <exception cref="BrokerException">The connection is broken.</exception>
    public Task EndAsync(CancellationToken cancellation) => TryAsync(
        "disconnecting",
        limited => _channel.SendPacketAsync(
            new MqttDisconnectPacket { ReasonCode = MqttDisconnectReasonCode.NormalDisconnection }, limited),
        cancellation);

    /// <inheritdoc/>
    public void Dispose() => _channel.Dispose();

    private Task LogInAsync(MqttConnectPacket login, CancellationToken cancellation) => TryAsync(
        "logging in",
        async limited =>
        {
            await _channel.SendPacketAsync(login, limited);
            var answer = await AnswerAsync<MqttConnAckPacket>(_ => true, limited);
            if (answer.ReasonCode != MqttConnectReasonCode.Success)
            {
                throw Of(ErrorOf(answer.ReasonCode), "logging in", Words(answer.ReasonCode, answer.ReasonString));
            }

            if (answer.MaximumQoS < MqttQualityOfServiceLevel.ExactlyOnce)
            {
                throw Of(BrokerError.Unsupported, "logging in", $"it takes messages with quality of service {(int)answer.MaximumQoS}");
            }
        },
        cancellation);

    private static BrokerError ErrorOf(MqttConnectReasonCode reason) => reason switch
    {
        MqttConnectReasonCode.BadUserNameOrPassword or MqttConnectReasonCode.NotAuthorized or MqttConnectReasonCode.Banned
            or MqttConnectReasonCode.BadAuthenticationMethod or MqttConnectReasonCode.ClientIdentifierNotValid => BrokerError.Login,
        MqttConnectReasonCode.UnsupportedProtocolVersion or MqttConnectReasonCode.QoSNotSupported => BrokerError.Unsupported,
        _ => BrokerError.Away,
    };

    // Waits for one kind of packet. Nothing is subscribed to, so anything else is a farewell or an answer that nobody waits for any more.
    private async Task<T> AnswerAsync<T>(Func<T, bool> isWanted, CancellationToken limited)
        where T : MqttPacket
    {
        while (true)
        {
            switch (await _channel.ReceivePacketAsync(limited))
            {
                case T answer when isWanted(answer):
                    return answer;
                case MqttDisconnectPacket farewell:
                    throw Of(BrokerError.Away, "waiting for its answer", Words(farewell.ReasonCode, farewell.ReasonString));
                case null:
                    limited.ThrowIfCancellationRequested();
                    throw Of(BrokerError.Away, "waiting for its answer", "it closed the connection");
                default:
                    continue;
            }
        }
    }

    private async Task TryAsync(string doing, Func<CancellationToken, Task> work, CancellationToken cancellation)
    {
        using var limited = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        limited.CancelAfter(_limit);
        try
        {
            await work(limited.Token);
            limited.Token.ThrowIfCancellationRequested();
        }
        catch (OperationCanceledException) when (cancellation.IsCancellationRequested)
        {
            throw;
        }
        catch (OperationCanceledException e)
        {
            // The library reports a connection that was aborted as canceled, too.
            throw Of(BrokerError.Away, doing, limited.IsCancellationRequested ? $"no answer within {_limit.TotalSeconds} s" : e.Message, e);
        }
        catch (MqttProtocolViolationException e)
        {
            throw Of(BrokerError.Unsupported, doing, e.Message, e);
        }
        catch (MqttCommunicationException e)
        {
            throw _trust.Reason is { } reason
                ? Of(BrokerError.WrongServer, doing, reason, e)
                : Of(BrokerError.Away, doing, e.InnerException?.Message ?? e.Message, e);
        }
    }

    private BrokerException Of(BrokerError error, string doing, string answer, Exception? cause = null) =>
        BrokerException.Of(error, _broker, doing, answer, cause);

    private static string Words<T>(T code, string? reason)
        where T : struct, Enum => string.IsNullOrEmpty(reason) ? $"the broker says {code}" : $"the broker says {code}, {reason}";
}
