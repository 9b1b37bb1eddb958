using System.Collections.Concurrent;
using System.Net;
using System.Security.Cryptography.X509Certificates;
using System.Text;
using System.Text.Json;
using MQTTnet;
using MQTTnet.Exceptions;
using MQTTnet.Formatter;
using MQTTnet.Protocol;

namespace ErrorMatching.Peers.Tests;

/// <summary>A plant's system that subscribes with a session of its own and counts what it hears by identity.</summary>
internal sealed class PlantSubscriber : IAsyncDisposable
{
    private readonly MosquittoPeer _broker;
    private readonly string _name;
    private readonly IMqttClient _client = new MqttClientFactory().CreateMqttClient();
    private readonly CancellationTokenSource _end = new();
    private readonly ConcurrentQueue<JsonElement> _heard = new();
    private readonly Task _loop;

    public PlantSubscriber(MosquittoPeer broker, string name = "plant")
    {
        (_broker, _name) = (broker, name);
        _client.ApplicationMessageReceivedAsync += Hear;
        _loop = Task.Run(StayAsync);
    }

    /// <summary>All messages, also those that came more than once, in the order in which they came.</summary>
    public IReadOnlyList<JsonElement> Raw => [.. _heard];

    /// <summary>The messages by identity, in the order in which each came first.</summary>
    public IReadOnlyList<JsonElement> ById => [.. _heard.DistinctBy(Id)];

    /// <summary>The text of the last message.</summary>
    public string Last { get; private set; } = "";

    public static string Id(JsonElement message) => message.GetProperty("id").GetString()!;

    /// <summary>Waits until it is connected and subscribed.</summary>
    public Task IsThere() => Until(() => Subscriptions > 0);

    public int Subscriptions { get; private set; }

    public bool IsConnected => _client.IsConnected;

    /// <summary>True while it does not want to be connected.</summary>
    public bool IsAway { get; set; }

    /// <summary>Waits until something is so.</summary>
    public static async Task Until(Func<bool> isSo)
    {
        for (var i = 0; i < 12_000; i++)
        {
            if (isSo())
            {
                return;
            }

            await Task.Delay(10, TestContext.Current.CancellationToken);
        }

        Assert.Fail("It did not come about within two minutes.");
    }

    public async ValueTask DisposeAsync()
    {
        await _end.CancelAsync();
        await _loop;
        _client.Dispose();
        _end.Dispose();
    }

    private Task Hear(MqttApplicationMessageReceivedEventArgs message)
    {
        Last = Encoding.UTF8.GetString(message.ApplicationMessage.Payload.First.Span);
        _heard.Enqueue(JsonDocument.Parse(Last).RootElement);
        return Task.CompletedTask;
    }

    private async Task StayAsync()
    {
        var authorities = X509CertificateLoader.LoadCertificateFromFile(_broker.AuthorityFile);
        var options = new MqttClientOptions
        {
            ClientId = _name,
            ProtocolVersion = MqttProtocolVersion.V500,
            CleanSession = false,
            SessionExpiryInterval = 3600,
            Timeout = TimeSpan.FromSeconds(5),
            Credentials = new MqttClientCredentials(MosquittoPeer.User, Encoding.UTF8.GetBytes(MosquittoPeer.Password)),
            ChannelOptions = new MqttClientTcpOptions
            {
                RemoteEndpoint = new IPEndPoint(IPAddress.Loopback, _broker.Port),
                TlsOptions = new MqttClientTlsOptions
                {
                    UseTls = true,
                    TargetHost = "127.0.0.1",
                    TrustChain = [authorities],
                    RevocationMode = X509RevocationMode.NoCheck,
                },
            },
        };
        while (!_end.IsCancellationRequested)
        {
            try
            {
                if (IsAway && _client.IsConnected)
                {
                    await _client.DisconnectAsync(new MqttClientDisconnectOptions(), _end.Token);
                }
                else if (!IsAway && !_client.IsConnected)
                {
                    await _client.ConnectAsync(options, _end.Token);
                    await _client.SubscribeAsync(MosquittoPeer.Topic, MqttQualityOfServiceLevel.ExactlyOnce, _end.Token);
                    Subscriptions++;
                }

                await Task.Delay(20, _end.Token);
            }
            catch (Exception e) when (e is MqttCommunicationException or OperationCanceledException or InvalidOperationException)
            {
                // The broker was killed; it comes back.
            }
        }
    }
}
